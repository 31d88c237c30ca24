/** The settings in the panel. */
import type { ChoiceSetting, NumberSetting, SwitchSetting } from '@principia/shell';

export const settings = {
  mission: {
    kind: 'choice',
    label: 'Mission',
    initial: 'circuit',
    choices: { 'A circuit': 'circuit', 'A landing': 'landing', 'Free flight': 'free' },
  },
  assist: {
    kind: 'switch',
    label: 'Assistant',
    initial: true,
    key: 'k',
    about: 'Holds the attitude that you fly; without it the stick moves the control surfaces',
  },
  inverted: {
    kind: 'switch',
    label: '↑ raises the nose',
    initial: false,
    about: 'In an aeroplane one pulls the stick back to raise the nose, so ↓ does',
  },
  crosswind: {
    kind: 'number',
    label: 'Crosswind',
    unit: 'm/s',
    initial: 0,
    min: -8,
    max: 8,
    integer: false,
    about: 'From the left where positive',
  },
  turbulence: { kind: 'number', label: 'Gusts', unit: 'm/s', initial: 0, min: 0, max: 4, integer: false },
  cockpit: { kind: 'switch', label: 'Cockpit', initial: false, key: 'c' },
  sound: { kind: 'switch', label: 'Sound', initial: true, key: 'm' },
} as const satisfies Record<string, NumberSetting | SwitchSetting | ChoiceSetting>;

export type Settings = typeof settings;
