/** The settings in the panel. */
import { numberSetting, switchSetting, type ValuesOf } from '@principia/shell';

const air = { unit: 'm/s', initial: 0, min: -15, max: 15 };
const glow = { unit: 's', initial: 0.4, min: 0, max: 1.5 };
const sparks = { unit: '', initial: 100_000, min: 1000, max: 200_000, integer: true };

export const settings = {
  wind: numberSetting(air, { label: 'Wind', step: 0.5, about: 'Sparks and shells drift with the wind' }),
  glow: numberSetting(glow, { label: 'Afterglow', step: 0.05, about: 'Time in which light fades' }),
  sound: switchSetting('Sound', true, { key: 'm', about: 'Sound reaches you with a delay, at 343 m/s' }),
  barrage: switchSetting('Barrage', false, { key: 'g', about: 'Random bursts with many sparks at once' }),
  sparks: numberSetting(sparks, {
    label: 'Barrage sparks',
    scale: 'log',
    about: 'Number of sparks that the barrage keeps alive',
  }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
