/** The settings in the panel. */
import { type Settings as AnySettings, switchSetting } from '@principia/shell';

const number = { kind: 'number', integer: false, min: 0 } as const;

export const settings = {
  gravity: { ...number, label: 'Gravity', unit: 'm/s²', initial: 9.81, max: 30 },
  wind: { ...number, label: 'Wind', unit: 'm/s', initial: 2, max: 10 },
  strength: {
    ...number,
    label: 'Strength',
    unit: 'N',
    initial: 2.5,
    min: 0.5,
    max: 50,
    scale: 'log',
    about: 'Tension at which a thread breaks',
  },
  sound: switchSetting('Sound', true, { key: 'm', about: 'Threads are heard as they tear' }),
} as const satisfies AnySettings;

export type Settings = typeof settings;
