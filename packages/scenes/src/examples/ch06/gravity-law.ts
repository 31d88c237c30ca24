import { createPhysicsWorld, mutualGravity, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf } from '../support/functions.ts';
import { velocityOf } from '../support/read.ts';

const DT = 1 / 240;
const DISTANCES = [1, 2, 4];
const force = (r: number, m1: number, m2: number) => (m1 * m2) / (r * r);

export default defineExample({
  id: 'ch06-gravity-law',
  title: 'Twice as far, a quarter of the force',
  chapter: 6,
  tags: ['gravity', 'forces'],
  about:
    'Newton’s law of gravity in a picture: the force is G times the product of the masses over the square of the distance. Here G is 1 N m²/kg², for handy numbers; the true G is fifteen thousand million times smaller. At twice the distance it is a quarter, at four times a sixteenth. It never becomes zero. Each of the two bodies feels the same force, in opposite directions, however different they are.',
  duration: 6,
  parameters: {
    m1: { label: 'First mass m₁', unit: 'kg', initial: 3, min: 1, max: 5 },
    m2: { label: 'Second mass m₂', unit: 'kg', initial: 5, min: 1, max: 5 },
  },
  build({ m1, m2 }: ValuesOf<'m1' | 'm2'>, { integrator = velocityVerlet }: BuildOptions) {
    // Pairs at three distances, so far from each other that they do not feel the other pairs.
    const world = createPhysicsWorld({ capacity: 8, forces: [mutualGravity({ G: 1 })], integrator });
    const pairs = DISTANCES.map((r, i) => [
      spawn(world, { position: { x: 1e9 * i }, velocity: {}, mass: m1 }),
      spawn(world, { position: { x: 1e9 * i + r }, velocity: {}, mass: m2 }),
    ]);
    // Mean force in the first step, from the momentum that a body has got.
    const pull = (i: number, which: 0 | 1) => ([m1, m2][which] * velocityOf(world, pairs[i][which]).x) / world.time;
    const r = () => 0.8 + (world.time % 6) * 0.7;
    return { world, dt: DT, pairs, pull, r };
  },
  picture({ r }, { m1, m2 }) {
    const at = () => ({ x: r(), y: force(r(), m1, m2) });
    return {
      graph: { x: { label: 'distance, m', step: 1 }, y: { label: 'force, N' } },
      view: { minX: 0, maxX: 5, minY: 0, maxY: m1 * m2 * 1.2 },
      curves: [{ points: graphOf((x) => force(x, m1, m2), 0.92, 5), color: COLORS.red }],
      lines: [
        ...DISTANCES.map((x) => ({ from: { x, y: 0 }, to: { x, y: force(x, m1, m2) }, color: COLORS.grey, width: 6 })),
        { from: () => ({ x: r(), y: 0 }), to: at, color: COLORS.orange },
      ],
      dots: [{ at, radius: 8 }],
      labels: DISTANCES.map((x) => ({
        at: { x: x + 0.05, y: force(x, m1, m2) },
        text: `${force(x, m1, m2).toFixed(2)} N`,
      })),
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(
      DT,
      'Force at 2 m, G m₁ m₂/r² with G = 1',
      { exact: ({ m1, m2 }) => (m1 * m2) / 4, unit: 'N', relative: 1e-4 },
      ({ pull }) => pull(1, 0),
    ),
    at(DT, 'Force at 4 m over that at 2 m', { exact: 0.25, relative: 1e-4 }, ({ pull }) => pull(2, 0) / pull(1, 0)),
    at(
      DT,
      'Both forces together, as a share of one',
      { exact: 0, absolute: 1e-15 },
      ({ pull }) => Math.abs(pull(1, 0) + pull(1, 1)) / Math.abs(pull(1, 0)),
    ),
  ],
  tryThis: [
    'Double one of the masses: the whole curve becomes twice as high.',
    'Follow the orange line: most of the force is gone before the distance has doubled once.',
  ],
});
