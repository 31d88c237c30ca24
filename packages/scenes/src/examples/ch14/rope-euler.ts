import { createPhysicsWorld, explicitEuler, semiImplicitEuler, spawn, uniformGravity } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, speedOf } from '../support/read.ts';
import { ropeLinks } from '../support/rope-links.ts';

/** A knot gets no faster than this, px/s. */
const BOILING = 1000;

const LINK = { stiffness: 500, damping: 20, length: 20 };

export default defineExample({
  id: 'ch14-rope-euler',
  title: 'A rope that boils over',
  chapter: 14,
  tags: ['integrators', 'rope', 'stability'],
  about:
    'A rope of springs and dampers hangs between two hooks. Explicit Euler stands the stiff dampers only while its step is shorter than c/k = 0.04 s. A little more, and each correction is larger than the error it should correct: the rope starts to tremble, and soon boils.',
  duration: 300,
  parameters: {
    dt: { label: 'Time step', unit: 's', initial: 0.038, min: 0.01, max: 0.06 },
    mass: { label: 'Mass of a knot', unit: 'kg', initial: 10, min: 8, max: 30 },
  },
  presets: [{ label: 'Too long a step', values: { dt: 0.05 } }],
  build({ dt, mass }: ValuesOf<'dt' | 'mass'>, { integrator = explicitEuler }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 32, forces: [uniformGravity({ y: 10 })], integrator });
    const ids = Array.from({ length: 16 }, (_, i) => {
      const knot = { position: { x: 100 + 20 * i, y: 100 }, velocity: {}, collider: 5 };
      return spawn(world, i === 0 || i === 15 ? knot : { ...knot, mass });
    });
    world.forces.push(ropeLinks(ids, LINK));
    // A rope that boils would soon be too fast for any number.
    const { x, y } = world.components.Velocity;
    world.phases.finish.push(() => {
      for (const id of ids) {
        const part = BOILING / Math.max(BOILING, speedOf(world, id));
        x[id] *= part;
        y[id] *= part;
      }
    });
    const fastest = () => Math.max(...ids.map((id) => speedOf(world, id)));
    return { world, dt, ids, fastest };
  },
  picture: ({ world, ids }) => ({
    yDown: true,
    view: { minX: 60, maxX: 440, minY: 40, maxY: 280 },
    lines: ids.slice(1).map((id, i) => ({
      from: () => positionOf(world, ids[i]),
      to: () => positionOf(world, id),
      color: COLORS.yellow,
    })),
  }),
  plots: (plot) => [
    plot('Fastest knot', 'speed, px/s', { label: 'speed', value: ({ fastest }) => Math.min(100, fastest()) }),
  ],
  checks: ({ at }) => [
    ...[explicitEuler, semiImplicitEuler].map((integrator) =>
      at(
        300,
        'Speed of the fastest knot after 300 s',
        { exact: 0, unit: 'px/s', absolute: 1e-3, integrator },
        ({ fastest }) => fastest(),
      ),
    ),
    at(
      300,
      'Height of the middle of the rope below the hooks',
      { exact: 59.757, unit: 'px', absolute: 0.05 },
      ({ world, ids }) => positionOf(world, ids[8]).y - 100,
    ),
    at(
      60,
      'With too long a step, speed after 60 s, at least 20',
      { exact: 20, unit: 'px/s', absolute: 0, preset: 'Too long a step' },
      ({ fastest }) => Math.min(20, fastest()),
    ),
  ],
  tryThis: [
    'Take too long a step, and then choose semi-implicit Euler: the rope hangs still again, with the same step.',
    'Take too long a step and make the knots heavier: it does not help, for there is no mass in c/k.',
  ],
});
