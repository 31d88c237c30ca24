import { cos, createPhysicsWorld, createRandom, energy, rgba, sin, spawn, vortex } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityOf } from '../support/read.ts';

const RADIUS = 100;
const MAX_COUNT = 300;

export default defineExample({
  id: 'ch07-vortex',
  title: 'Leaves on the rim of a whirl',
  chapter: 7,
  tags: ['vortex', 'force', 'particles'],
  about:
    'A simple model of a whirl, as seen by someone who turns with it. Inside the core the centrifugal force drives things away from the centre; outside, the low pressure of the core draws them in. So they swing to and fro across the rim. At the rim the force is k r on both sides, but turns round: a jump that no step of a program can follow exactly.',
  duration: 30,
  parameters: {
    strength: { label: 'Strength k', unit: '1/s²', initial: 0.25, min: 0.02, max: 2 },
    count: { label: 'Leaves', initial: 60, min: 1, max: MAX_COUNT, integer: true },
    speed: { label: 'Largest speed at the start', unit: 'px/s', initial: 20, min: 0, max: 60 },
  },
  presets: [{ label: 'All from rest', values: { speed: 0 } }],
  build({ strength, count, speed }, { seed, ...options }) {
    const world = createPhysicsWorld({
      capacity: MAX_COUNT + 8,
      forces: [vortex({ strength, radius: RADIUS })],
      ...options,
    });
    const random = createRandom(seed);
    const leaves = Array.from({ length: count }, () => {
      const position = { x: random.uniform(-230, 230), y: random.uniform(-170, 170) };
      const velocity = { x: random.uniform(-speed, speed), y: random.uniform(-speed, speed) };
      const appearance = { size: 4, color: rgba(random.uniform(0.6, 1), 0.75, 0.3) };
      return spawn(world, { position, velocity, mass: 1, appearance });
    });
    const probe = (x: number) =>
      spawn(world, { position: { x }, velocity: {}, mass: 1, appearance: { size: 6, color: rgba(1, 1, 1) } });
    const [inside, outside] = [probe(RADIUS * 0.999), probe(RADIUS * 1.001)];
    const start = energy(world).total;
    return { world, dt: 1 / 240, leaves, inside, outside, change: () => energy(world).total / start - 1 };
  },
  picture({ leaves }) {
    const rim = (a: number) => ({ x: RADIUS * cos(a), y: RADIUS * sin(a) });
    return {
      view: { minX: -250, maxX: 250, minY: -190, maxY: 190 },
      fills: [{ shape: { centre: { x: 0, y: 0 }, radius: RADIUS }, color: COLORS.water, opacity: 0.3 }],
      curves: [{ points: pointsOf(rim, 0, 2 * Math.PI), color: COLORS.blue, label: 'rim of the core' }],
      trails: leaves.slice(0, 20).map((body) => ({ body, length: 250, interval: 4 })),
    };
  },
  plots: (plot) => [
    plot('Change of the energy', 'change, fraction', { label: 'all', value: ({ change }) => change() }),
  ],
  checks: ({ at }) => [
    at(
      1 / 240,
      'Acceleration just inside the rim, outwards: k r',
      { exact: ({ strength }) => strength * RADIUS, unit: 'px/s²', relative: 0.002 },
      ({ world, inside }) => velocityOf(world, inside).x / world.time,
    ),
    // (r₀/r)⁴ r is by 3 · 0.001 less than r₀ there.
    at(
      1 / 240,
      'Acceleration just outside, inwards',
      { exact: ({ strength }) => -strength * RADIUS, unit: 'px/s²', relative: 0.004 },
      ({ world, outside }) => velocityOf(world, outside).x / world.time,
    ),
  ],
  tryThis: [
    'Choose “All from rest”: every leaf swings on a straight line through the rim.',
    'Make the whirl four times as strong: the leaves swing twice as fast.',
  ],
});
