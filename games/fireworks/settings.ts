/** The settings in the panel. */
import { numberSetting, switchSetting, type ValuesOf } from '@principia/shell';
import { WORDS } from './words.ts';

const { wind, glow, sound, barrage, sparks } = WORDS.settings;
const air = { unit: 'm/s', initial: 0, min: -15, max: 15 };
const fading = { unit: 's', initial: 0.4, min: 0, max: 1.5 };
const crowd = { unit: '', initial: 100_000, min: 1000, max: 200_000, integer: true };

export const settings = {
  wind: numberSetting(air, { label: wind[0], about: wind[1], step: 0.5 }),
  glow: numberSetting(fading, { label: glow[0], about: glow[1], step: 0.05 }),
  sound: switchSetting(sound[0], true, { key: 'm', about: sound[1] }),
  barrage: switchSetting(barrage[0], false, { key: 'g', about: barrage[1] }),
  sparks: numberSetting(crowd, {
    label: sparks[0],
    scale: 'log',
    about: sparks[1],
  }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
