/** The settings in the panel. */
import { type Settings as AnySettings, switchSetting } from '@principia/shell';
import { WORDS } from './words.ts';

const { settings: words } = WORDS;
const number = { kind: 'number', integer: false, min: 0 } as const;

export const settings = {
  gravity: { ...number, label: words.gravity, unit: 'm/s²', initial: 9.81, max: 30 },
  wind: { ...number, label: words.wind, unit: 'm/s', initial: 2, max: 10 },
  strength: {
    ...number,
    label: words.strength[0],
    unit: 'N',
    initial: 2.5,
    min: 0.5,
    max: 50,
    scale: 'log',
    about: words.strength[1],
  },
  sound: switchSetting(words.sound[0], true, { key: 'm', about: words.sound[1] }),
} as const satisfies AnySettings;

export type Settings = typeof settings;
