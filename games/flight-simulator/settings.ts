/** The settings in the panel. */
import type { ChoiceSetting, NumberSetting, SwitchSetting } from '@principia/shell';
import { WORDS } from './words.ts';

const { settings: words, missions } = WORDS;

export const settings = {
  mission: {
    kind: 'choice',
    label: words.mission,
    initial: 'circuit',
    choices: Object.fromEntries(Object.entries(missions).map(([name, label]) => [label, name])),
  },
  assist: {
    kind: 'switch',
    label: words.assist[0],
    initial: true,
    key: 'k',
    about: words.assist[1],
  },
  altitudeHold: { kind: 'switch', label: words.hold[0], initial: false, key: 'l', about: words.hold[1] },
  inverted: {
    kind: 'switch',
    label: words.inverted[0],
    initial: false,
    about: words.inverted[1],
  },
  crosswind: {
    kind: 'number',
    label: words.crosswind[0],
    unit: 'm/s',
    initial: 0,
    min: -8,
    max: 8,
    integer: false,
    about: words.crosswind[1],
  },
  turbulence: {
    kind: 'number',
    label: words.turbulence[0],
    unit: 'm/s',
    initial: 0,
    min: 0,
    max: 3,
    integer: false,
    about: words.turbulence[1],
  },
  unsteady: { kind: 'switch', label: words.unsteady[0], initial: true, about: words.unsteady[1] },
  propwash: { kind: 'switch', label: words.propwash[0], initial: true, about: words.propwash[1] },
  cockpit: { kind: 'switch', label: words.cockpit, initial: false, key: 'c' },
  sound: { kind: 'switch', label: words.sound, initial: true, key: 'm' },
} as const satisfies Record<string, NumberSetting | SwitchSetting | ChoiceSetting>;

export type Settings = typeof settings;
