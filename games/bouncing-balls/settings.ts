/** The settings in the panel. */
import { numberSetting, switchSetting, type ValuesOf } from '@principia/shell';
import { parameters } from './sim.ts';
import { WORDS } from './words.ts';

const { count, gravity, restitution, drag, friction } = parameters;

const { settings: words, planets } = WORDS;

/** Surface gravity, m/s²: NASA Planetary Fact Sheet. */
const PLANETS = {
  [planets.space]: 0,
  [planets.moon]: 1.62,
  [planets.mars]: 3.71,
  [planets.earth]: gravity.initial,
  [planets.saturn]: 10.44,
  [planets.jupiter]: 24.79,
};

export const settings = {
  count: numberSetting(count, { label: words.count, initial: 200, max: 100_000, scale: 'log' }),
  gravity: numberSetting(gravity, { label: words.gravity, max: 30, presets: PLANETS }),
  restitution: numberSetting(restitution, { label: words.restitution, initial: 0.9 }),
  friction: numberSetting(friction, { label: words.friction, max: 1 }),
  drag: numberSetting(drag, { label: words.drag, max: 100, step: 0.1 }),
  collisions: switchSetting(words.collisions[0], true, { key: 'c', about: words.collisions[1] }),
  wrap: switchSetting(words.wrap[0], false, { key: 'u', about: words.wrap[1] }),
  magnet: switchSetting(words.magnet[0], false, { key: 'g', about: words.magnet[1] }),
  sound: switchSetting(words.sound[0], true, { key: 'm', about: words.sound[1] }),
  trails: switchSetting(words.trails[0], false, { key: 't', about: words.trails[1] }),
};

export type Settings = typeof settings;
export type Values = ValuesOf<Settings>;
