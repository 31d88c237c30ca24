/** The settings in the panel. */
import { type NumberSetting, switchSetting } from '@principia/shell';
import { WORDS } from './words.ts';

const { settings: words } = WORDS;

const level: NumberSetting = {
  kind: 'number',
  label: words.level[0],
  unit: '',
  initial: 1,
  min: 1,
  max: 9,
  integer: true,
  about: words.level[1],
};

export const settings = {
  level,
  floodlight: switchSetting(words.floodlight[0], true, { key: 'l', about: words.floodlight[1] }),
  sound: switchSetting(words.sound, true, { key: 'm' }),
};

export type Settings = typeof settings;
