/** What the panel offers. */
import { numberSetting, switchSetting, type ValuesOf } from '@principia/shell';

const air = { unit: 'm/s', initial: 0, min: -15, max: 15 };
const glow = { unit: 's', initial: 0.4, min: 0, max: 1.5 };
const sparks = { unit: '', initial: 100_000, min: 1000, max: 200_000, integer: true };

export const settings = {
  wind: numberSetting(air, { label: 'Wind', step: 0.5, about: 'Sparks and shells drift with it' }),
  glow: numberSetting(glow, { label: 'Afterglow', step: 0.05, about: 'How long light lingers in the eye' }),
  sound: switchSetting('Sound', true, { key: 'm', about: 'Heard as late as sound takes to you, at 343 m/s' }),
  barrage: switchSetting('Barrage', false, { key: 'g', about: 'As many sparks at once as you like' }),
  sparks: numberSetting(sparks, { label: 'Its sparks', scale: 'log', about: 'How many the barrage keeps alive' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
