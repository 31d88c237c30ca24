/** What the panel offers. */
import { switchSetting, type ValuesOf } from '@principia/shell';

export const settings = {
  fuel: switchSetting('Fuel', true, { key: 'u', about: 'A tank for every flight; what is left gives bonus points' }),
  moving: switchSetting('Moving holes', true, { about: 'From level 5 on, some holes run on circles' }),
  steep: switchSetting('Steep pull', false, {
    key: 'q',
    about: 'After Paczyński and Wiita: endless at the horizon, and no circle nearer than three radii is stable',
  }),
  path: switchSetting('Path ahead', true, { key: 'v', about: 'Where the ship goes in the next two seconds' }),
  trail: switchSetting('Trail', true, { key: 't', about: 'Where the ship came from' }),
  lens: switchSetting('Bent light', true, { key: 'l', about: 'Holes bend the light of the stars behind them' }),
  glow: switchSetting('Hawking glow', true, {
    key: 'g',
    about: 'Holes glow; the smaller, the hotter and the brighter',
  }),
  autopilot: switchSetting('Autopilot', false, { key: 'a', about: 'The game plays itself' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
