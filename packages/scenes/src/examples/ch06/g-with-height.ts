import { createPhysicsWorld, spawn, uniformSphereGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf } from '../support/functions.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const G0 = 9.81;
/** Gravity at a distance in radii of the Earth: linear inside, inverse square outside. */
const gravity = (r: number) => (r < 1 ? G0 * r : G0 / (r * r));

export default defineExample({
  id: 'ch06-g-with-height',
  title: 'Gravity inside and outside the Earth',
  chapter: 6,
  tags: ['gravity', 'earth', 'functions'],
  about:
    'Above the ground gravity becomes weaker with the square of the distance from the centre. In a deep shaft it becomes weaker, too: the shells above you pull to all sides and cancel, and in the very centre nothing is left. The dot is a stone that falls through a tunnel across the whole Earth and on to the other side.',
  duration: 30,
  parameters: { start: { label: 'Start, in radii of the Earth', initial: 1, min: 0.2, max: 3 } },
  presets: [
    { label: 'From far above', values: { start: 3 } },
    { label: 'Deep in the shaft', values: { start: 0.5 } },
  ],
  build({ start }: ValuesOf<'start'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({
      capacity: 4,
      forces: [uniformSphereGravity({ mu: G0, radius: 1 })],
      integrator,
    });
    const ball = spawn(world, { position: { y: start }, velocity: {}, mass: 1 });
    return { world, dt: 1 / 240, ball, r: () => Math.abs(positionOf(world, ball).y) };
  },
  picture: ({ r }) => ({
    graph: { x: { label: 'r in radii of the Earth', step: 1 }, y: { label: 'g, m/s²', step: 1 } },
    view: { minX: 0, maxX: 10, minY: 0, maxY: 10.5 },
    curves: [{ points: graphOf(gravity, 0, 10, 1000), color: COLORS.red }],
    lines: [
      { from: { x: 1, y: 0 }, to: { x: 1, y: 10.5 }, color: COLORS.grey, width: 1 },
      { from: () => ({ x: r(), y: 0 }), to: () => ({ x: r(), y: gravity(r()) }), color: COLORS.orange },
    ],
    dots: [{ at: () => ({ x: r(), y: gravity(r()) }), radius: 8 }],
    labels: [{ at: { x: 1.1, y: 10 }, text: 'the ground', color: COLORS.grey }],
  }),
  plots: (plot) => [
    plot('Distance from the centre', 'r, radii', {
      label: 'stone',
      value: ({ world, ball }) => positionOf(world, ball).y,
    }),
  ],
  checks: ({ at, largest }) => [
    ...[0.5, 1, 2, 10].map((r) =>
      at(
        0,
        `Gravity at ${r === 1 ? 'one radius' : `${r} radii`}`,
        { exact: { 0.5: 4.905, 1: 9.81, 2: 2.4525, 10: 0.0981 }[r] as number, unit: 'm/s²', absolute: 1e-12 },
        () => gravity(r),
      ),
    ),
    {
      label: 'Time to the other side and back, 2π √(R/g₀) in these units',
      unit: 's',
      exact: (2 * Math.PI) / Math.sqrt(G0),
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, ball }) => positionOf(world, ball).y, from: 1, to: 2 },
    },
    largest(
      4,
      'Largest speed in the centre, √(g₀ R)',
      { exact: Math.sqrt(G0), unit: 'radii/s', relative: 1e-4 },
      ({ world, ball }) => Math.abs(velocityOf(world, ball).y),
    ),
  ],
  tryThis: [
    'Start deep in the shaft: the stone needs exactly as long to come back as from the ground.',
    'Start three radii out: the orange line is short at first, is longest at the ground, and vanishes in the centre.',
  ],
});
