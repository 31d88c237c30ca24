/** The settings in the panel. */
import { switchSetting, type ValuesOf } from '@principia/shell';
import { WORDS } from './words.ts';

const { enlarged, orbits, trails, names, moon, sound } = WORDS.settings;

export const settings = {
  enlarged: switchSetting(enlarged[0], true, { key: 'x', about: enlarged[1] }),
  orbits: switchSetting(orbits[0], true, { key: 'o', about: orbits[1] }),
  trails: switchSetting(trails[0], false, { key: 't', about: trails[1] }),
  names: switchSetting(names, true, { key: 'n' }),
  moon: switchSetting(moon[0], true, { key: 'l', about: moon[1] }),
  sound: switchSetting(sound, true, { key: 'm' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
