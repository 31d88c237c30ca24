import { angularMomentum, atan2, createPhysicsWorld, powerLaw, rgba, rungeKutta4, spawn } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import type { Check } from '../check.ts';
import { choiceOf, defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 250 };
/** Exponents n, strengths k, and the nearest distance and the time between two of them. */
const LAWS = [
  { name: '1/r', exponent: -1, strength: -1000, near: 89.026, period: 20.5637 },
  { name: '1/r²: gravity', exponent: -2, strength: -1e5, near: 133.333, period: 42.7515 },
  { name: 'r: a spring', exponent: 1, strength: -1, near: 20, period: Math.PI },
] as const;

interface Run extends SceneRun {
  readonly body: number;
  readonly distance: () => number;
  /** Turns from falling to rising at the nearest point. */
  readonly rising: () => number;
}

/** Where the nearest point is, and how long it takes from one to the next. */
function ranges(law: number, preset?: string): Check<Run, unknown>[] {
  const { name, near, period } = LAWS[law];
  const [tolerance, about] = [{ relative: 1e-3 }, preset === undefined ? {} : { preset }];
  const event = ({ rising }: Run) => rising();
  const distance: Check<Run, unknown> = {
    label: `Nearest distance, ${name}`,
    unit: 'px',
    exact: near,
    tolerance,
    at: { event },
    measure: (run) => run.distance(),
    ...about,
  };
  const time: Check<Run, unknown> = {
    label: `Time from one nearest point to the next, ${name}`,
    unit: 's',
    exact: period,
    tolerance,
    at: { event, from: 1, to: 2 },
    ...about,
  };
  return [distance, time];
}

export default defineExample({
  id: 'ch10-central-forces',
  title: 'Orbits under other laws',
  chapter: 10,
  tags: ['orbit', 'central force', 'angular momentum'],
  about:
    'A force towards a centre that falls as 1/r draws a rosette: in every turn the nearest point is another. Only two laws draw closed curves whatever the start, gravity and the spring; Bertrand proved that in 1873. The angular momentum stays the same under all of them.',
  duration: 90,
  parameters: {
    law: choiceOf(
      'Force as',
      LAWS.map(({ name }) => name),
    ),
    speed: { label: 'Speed at the start', unit: 'px/s', initial: 20, min: 10, max: 30 },
  },
  presets: [
    { label: 'Gravity', values: { law: 1 } },
    { label: 'A spring', values: { law: 2 } },
  ],
  build({ law, speed }, { integrator = rungeKutta4 }): Run {
    const { exponent, strength } = LAWS[law];
    const force = powerLaw({ strength, exponent, centre: CENTRE });
    const world = createPhysicsWorld({ capacity: 4, forces: [force], integrator });
    spawn(world, { position: CENTRE, appearance: { size: 7, color: rgba(1, 0.85, 0.4) } });
    const body = spawn(world, { position: { x: 150, y: 250 }, velocity: { y: -speed }, mass: 1, collider: 8 });
    const distance = () => distanceBetween(positionOf(world, body), CENTRE);
    const rising = () => {
      const [{ x, y }, v] = [positionOf(world, body), velocityOf(world, body)];
      return (x - CENTRE.x) * v.x + (y - CENTRE.y) * v.y;
    };
    return { world, dt: 1 / 240, body, distance, rising };
  },
  picture({ world, body }) {
    return {
      yDown: true,
      view: { minX: 120, maxX: 580, minY: 30, maxY: 470 },
      trails: [{ body, length: 3000, interval: 6 }],
      arrows: [velocityArrow(world, body, 1)],
    };
  },
  plots: (plot) => [
    plot('Distance', 'r, px', { label: 'body', value: ({ distance }) => distance() }),
    plot('Angular momentum, clockwise', 'L, kg px²/s', {
      label: 'body',
      value: ({ world }) => angularMomentum(world, CENTRE).z,
    }),
  ],
  checks: ({ at }) => [
    ...ranges(0),
    ...ranges(1, 'Gravity'),
    ...ranges(2, 'A spring'),
    {
      label: 'How far the nearest point of 1/r moves in a turn: 108.8° back',
      unit: '°',
      exact: -108.8,
      tolerance: { relative: 1e-3 },
      at: { event: ({ rising }) => rising(), from: 1, to: 2 },
      measure: ({ world, body }) => {
        const { x, y } = positionOf(world, body);
        return (atan2(CENTRE.y - y, CENTRE.x - x) * 180) / Math.PI;
      },
    },
    at(
      60,
      'Angular momentum after 60 s, clockwise',
      { exact: ({ speed }) => 200 * speed, unit: 'kg px²/s', relative: 1e-9 },
      ({ world }) => angularMomentum(world, CENTRE).z,
    ),
  ],
  tryThis: [
    'Let the first law run for a minute: the rosette fills a ring, and never closes.',
    'Choose “A spring”: the curve is an ellipse, but its centre is the centre of the force, and not a focus.',
  ],
});
