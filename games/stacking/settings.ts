/** The settings in the panel. */
import type { ChoiceSetting, NumberSetting } from '@principia/shell';
import { WORDS } from './words.ts';

const { settings: words, builds, layers } = WORDS;

const number = { kind: 'number', integer: false, min: 0 } as const;

export const settings = {
  build: {
    kind: 'choice',
    label: words.build,
    initial: 'tower',
    choices: Object.fromEntries(Object.entries(builds).map(([name, label]) => [label, name])),
  },
  count: {
    ...number,
    label: words.count[0],
    unit: '',
    initial: 90,
    min: 10,
    max: 10_000,
    integer: true,
    scale: 'log',
    about: words.count[1],
  },
  gravity: { ...number, label: words.gravity, unit: 'm/s²', initial: 9.81, max: 30 },
  friction: { ...number, label: words.friction, unit: '', initial: 0.6, max: 1.5 },
  restitution: { ...number, label: words.restitution, unit: '', initial: 0, max: 1 },
  layer: {
    kind: 'choice',
    label: words.layer[0],
    initial: 'none',
    choices: Object.fromEntries(Object.entries(layers).map(([name, label]) => [label, name])),
    about: words.layer[1],
  },
} as const satisfies Record<string, NumberSetting | ChoiceSetting>;

export type Settings = typeof settings;
