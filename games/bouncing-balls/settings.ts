/** The settings in the panel. */
import { numberSetting, switchSetting, type ValuesOf } from '@principia/shell';
import { parameters } from './sim.ts';

const { count, gravity, restitution, drag, friction } = parameters;

export const settings = {
  count: numberSetting(count, { label: 'Balls', max: 100_000, scale: 'log' }),
  gravity: numberSetting(gravity, { label: 'Gravity', max: 30 }),
  restitution: numberSetting(restitution, { label: 'Restitution' }),
  friction: numberSetting(friction, { label: 'Friction', max: 1 }),
  drag: numberSetting(drag, { label: 'Air density', max: 100, step: 0.1 }),
  collisions: switchSetting('Collisions', false, {
    key: 'c',
    about: 'Whether balls collide or pass through each other',
  }),
  trails: switchSetting('Trails', false, { key: 't', about: 'Shows the recent path of each ball' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
