/** The settings in the panel. */
import { numberSetting, switchSetting, type ValuesOf } from '@principia/shell';
import { parameters } from './sim.ts';

const { count, gravity, restitution, drag, friction } = parameters;

/** Surface gravity, m/s²: NASA Planetary Fact Sheet. */
const PLANETS = { Space: 0, Moon: 1.62, Mars: 3.71, Earth: gravity.initial, Saturn: 10.44, Jupiter: 24.79 };

export const settings = {
  count: numberSetting(count, { label: 'Balls', initial: 200, max: 100_000, scale: 'log' }),
  gravity: numberSetting(gravity, { label: 'Gravity', max: 30, presets: PLANETS }),
  restitution: numberSetting(restitution, { label: 'Restitution', initial: 0.9 }),
  friction: numberSetting(friction, { label: 'Friction', max: 1 }),
  drag: numberSetting(drag, { label: 'Air density', max: 100, step: 0.1 }),
  collisions: switchSetting('Collisions', true, {
    key: 'c',
    about: 'Whether balls collide or pass through each other',
  }),
  wrap: switchSetting('Wrap around', false, {
    key: 'u',
    about: 'Balls that leave at one side come back at the other',
  }),
  sound: switchSetting('Sound', true, { key: 'm', about: 'Impacts sound, the louder the faster' }),
  trails: switchSetting('Trails', false, { key: 't', about: 'Shows the recent path of each ball' }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
