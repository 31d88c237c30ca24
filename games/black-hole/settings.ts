/** The settings in the panel. */
import { type NumberSetting, switchSetting, type ValuesOf } from '@principia/shell';
import { ReachedLevel } from './reached.ts';
import { WORDS } from './words.ts';

const { settings: words } = WORDS;

/** What the player has reached, and with it what the panel offers. */
export const reached = new ReachedLevel(globalThis.location?.search ?? '');

const level: NumberSetting = {
  kind: 'number',
  label: words.level[0],
  unit: '',
  initial: 1,
  min: 1,
  get max() {
    return reached.highest;
  },
  integer: true,
  about: words.level[1],
};

export const settings = {
  level,
  fuel: switchSetting(words.fuel[0], true, { key: 'u', about: words.fuel[1] }),
  moving: switchSetting(words.moving[0], true, { about: words.moving[1] }),
  steep: switchSetting(words.steep[0], false, { key: 'q', about: words.steep[1] }),
  path: switchSetting(words.path[0], true, { key: 'v', about: words.path[1] }),
  trail: switchSetting(words.trail[0], true, { key: 't', about: words.trail[1] }),
  ghost: switchSetting(words.ghost[0], true, { key: 'c', about: words.ghost[1] }),
  lens: switchSetting(words.lens[0], true, { key: 'l', about: words.lens[1] }),
  glow: switchSetting(words.glow[0], true, { key: 'g', about: words.glow[1] }),
  sound: switchSetting(words.sound, true, { key: 'm' }),
  autopilot: switchSetting(words.autopilot[0], false, { key: 'a', about: words.autopilot[1] }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
