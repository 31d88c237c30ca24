/** The settings in the panel. */
import { type NumberSetting, switchSetting, type ValuesOf } from '@principia/shell';

const level: NumberSetting = {
  kind: 'number',
  label: 'First level',
  unit: '',
  initial: 1,
  min: 1,
  max: 12,
  integer: true,
  about: 'A game that begins higher is not ranked',
};

export const settings = {
  level,
  fuel: switchSetting('Fuel', true, {
    key: 'u',
    about: 'A limited tank for every flight; unused fuel gives bonus points',
  }),
  moving: switchSetting('Moving holes', true, { about: 'From level 5 on, some holes move on circles' }),
  steep: switchSetting('Relativistic gravity', false, {
    key: 'q',
    about: 'Paczyński–Wiita potential: infinite at the horizon, and no stable circular orbit within three radii',
  }),
  path: switchSetting('Predicted path', true, { key: 'v', about: 'The flight of the next two seconds' }),
  trail: switchSetting('Trail', true, { key: 't', about: 'The recent path of the ship' }),
  ghost: switchSetting('Ghost', true, {
    key: 'c',
    about: 'Your fastest flight past the same holes flies beside you as a pale ship',
  }),
  lens: switchSetting('Light bending', true, { key: 'l', about: 'Holes bend the light of the stars behind them' }),
  glow: switchSetting('Hawking glow', true, {
    key: 'g',
    about: 'Holes glow: smaller ones are hotter and brighter',
  }),
  sound: switchSetting('Sound', true, { key: 'm' }),
  autopilot: switchSetting('Autopilot', false, { key: 'a', about: 'The game plays itself' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
