/** The settings in the panel. */
import type { ChoiceSetting, NumberSetting } from '@principia/shell';

const number = { kind: 'number', integer: false, min: 0 } as const;

export const settings = {
  build: {
    kind: 'choice',
    label: 'Build',
    initial: 'tower',
    choices: { Tower: 'tower', Pyramid: 'pyramid', Dominoes: 'dominoes', Bridge: 'bridge', Mixed: 'mixed' },
  },
  count: {
    ...number,
    label: 'Bodies',
    unit: '',
    initial: 90,
    min: 10,
    max: 10_000,
    integer: true,
    scale: 'log',
    about: 'How many bodies the build has, roughly',
  },
  gravity: { ...number, label: 'Gravity', unit: 'm/s²', initial: 9.81, max: 30 },
  friction: { ...number, label: 'Friction', unit: '', initial: 0.6, max: 1.5 },
  restitution: { ...number, label: 'Restitution', unit: '', initial: 0, max: 0.9 },
  layer: {
    kind: 'choice',
    label: 'Show',
    initial: 'none',
    choices: {
      'Bodies only': 'none',
      Contacts: 'contacts',
      'Contacts by colour': 'colors',
      'Boxes and sleep': 'boxes',
      Islands: 'islands',
    },
    about: 'What the engine knows, drawn over the bodies',
  },
} as const satisfies Record<string, NumberSetting | ChoiceSetting>;

export type Settings = typeof settings;
