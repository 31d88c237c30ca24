/** The settings in the panel. */
import { type NumberSetting, switchSetting } from '@principia/shell';

const level: NumberSetting = {
  kind: 'number',
  label: 'Level',
  unit: '',
  initial: 1,
  min: 1,
  max: 9,
  integer: true,
  about: 'A deeper sea, stronger currents, and more crates',
};

export const settings = {
  level,
  floodlight: switchSetting('Floodlight', true, { key: 'l', about: 'Shows the bed near the boat' }),
  sound: switchSetting('Sound', true, { key: 'm' }),
};

export type Settings = typeof settings;
