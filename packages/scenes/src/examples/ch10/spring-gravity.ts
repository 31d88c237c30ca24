import {
  createPhysicsWorld,
  createRandom,
  positionFirstEuler,
  powerLaw,
  rgba,
  rungeKutta4,
  spawn,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const CENTRE = { x: 400, y: 300 };
const PERIOD = 2 * Math.PI;
const MAX_COUNT = 300;

export default defineExample({
  id: 'ch10-spring-gravity',
  title: 'If gravity grew with the distance',
  chapter: 10,
  tags: ['central force', 'oscillation', 'spring'],
  about:
    'Suppose gravity were twice as strong at twice the distance, like a spring. Then everything, from wherever and however fast it starts, is back after the same time, here 2π seconds. The cloud flies apart, turns itself inside out, and is whole again.',
  duration: 4 * PERIOD,
  parameters: {
    count: { label: 'Bodies', initial: 50, min: 1, max: MAX_COUNT, integer: true },
    speed: { label: 'Largest speed at the start', unit: 'px/s', initial: 50, min: 0, max: 300 },
  },
  presets: [{ label: 'All from rest', values: { speed: 0 } }],
  build({ count, speed }, { seed, integrator = rungeKutta4 }) {
    const law = powerLaw({ strength: -1, exponent: 1, centre: CENTRE });
    const world = createPhysicsWorld({ capacity: MAX_COUNT + 4, forces: [law], integrator });
    spawn(world, { position: CENTRE, appearance: { size: 9, color: rgba(1, 0.4, 0.4) } });
    const random = createRandom(seed);
    const starts = Array.from({ length: count }, () => ({ x: random.uniform(0, 800), y: random.uniform(0, 600) }));
    const ids = starts.map((position) => {
      const velocity = { x: random.uniform(-speed, speed), y: random.uniform(-speed, speed) };
      return spawn(world, { position, velocity, mass: 1, appearance: { size: 5, color: rgba(0.6, 0.8, 1) } });
    });
    const worst = () =>
      ids.reduce((most, id, i) => Math.max(most, distanceBetween(positionOf(world, id), starts[i])), 0);
    return { world, dt: PERIOD / 377, ids, worst };
  },
  picture({ ids }) {
    return {
      yDown: true,
      view: { minX: -10, maxX: 810, minY: -10, maxY: 610 },
      trails: ids.slice(0, 12).map((body) => ({ body, length: 380 })),
    };
  },
  plots: (plot) => [
    plot('Largest distance from the start', 'distance, px', { label: 'of all', value: ({ worst }) => worst() }),
  ],
  checks: ({ at }) => [
    at(
      PERIOD,
      'Largest distance from the start after 2π s',
      { exact: 0, unit: 'px', absolute: 4e-7, integrator: rungeKutta4 },
      ({ worst }) => worst(),
    ),
    at(
      PERIOD,
      'Largest distance from the start after 2π s',
      { exact: 0, unit: 'px', absolute: 0.01, integrator: positionFirstEuler },
      ({ worst }) => worst(),
    ),
  ],
  tryThis: [
    'Choose “All from rest”: they meet in the centre, all at the same moment.',
    'Look at the plot: four times in the run the cloud is exactly as it was.',
  ],
});
