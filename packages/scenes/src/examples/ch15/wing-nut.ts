import { angularMomentum, createPhysicsWorld, energy, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { tumblingPeriod } from '../support/free-rotation.ts';
import { lengthOf } from '../support/read.ts';
import { dot, orientationOf, point, pointOn, rotate, times } from '../support/space.ts';

type Values = ValuesOf<'spin' | 'nudge' | 'middle'>;

const DT = 1 / 120;
const SMALLEST = 1;
const LARGEST = 2.5;
const momentsOf = ({ middle }: Values) => point(SMALLEST, middle, LARGEST);
const spinOf = ({ spin, nudge }: Values) => point(nudge, spin, nudge);

export default defineExample({
  id: 'ch15-wing-nut',
  title: 'The wing nut that turns over',
  chapter: 15,
  tags: ['3D', 'rotation', 'inertia', 'stability'],
  about:
    'In 1985 the cosmonaut Dzhanibekov saw a wing nut fly off its bolt, spin on steadily, turn over, spin on, and turn over again. Nothing pushes it: a body spins stably about the axes of its largest and its smallest moment of inertia, and never about the one between. The angular momentum L, the violet arrow, stays where it is.',
  dimensions: 3,
  duration: 32,
  parameters: {
    spin: { label: 'Spin', unit: 'rad/s', initial: 5, min: 1, max: 10 },
    nudge: { label: 'Nudge', unit: 'rad/s', initial: 0.01, min: 1e-4, max: 1, scale: 'log' },
    middle: { label: 'Inertia about the stem', unit: 'kg m²', initial: 2, min: 1.5, max: 2.4 },
  },
  presets: [
    { label: 'A hundredth of the nudge', values: { nudge: 1e-4 } },
    { label: 'Nearly a symmetric top', values: { middle: 2.4, nudge: 0.5 } },
  ],
  build(values: Values, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4, integrator });
    const nut = spawn(world, {
      position: {},
      mass: 1,
      orientation: {},
      inertiaTensor: momentsOf(values),
      angularVelocity: spinOf(values),
    });
    const spin = () => {
      const { AngularVelocity: w } = world.components;
      return dot(point(w.x[nut], w.y[nut], w.z[nut]), rotate(orientationOf(world, nut), point(0, 1, 0)));
    };
    const start = { energy: energy(world).kinetic, momentum: angularMomentum(world) };
    return { world, dt: DT, nut, spin, start };
  },
  picture({ world, nut, start }) {
    const place = (x: number, y: number, z = 0) => pointOn(world, nut, point(x, y, z));
    const line = (a: readonly [number, number, number?], b: readonly [number, number, number?], color: number) => ({
      from: () => place(...a),
      to: () => place(...b),
      color,
      width: 5,
    });
    return {
      view: { minX: -1.3, maxX: 1.3, minY: -1.2, maxY: 1.2, minZ: -1, maxZ: 1 },
      camera: { eye: point(2, 1.5, 5), target: point(0, 0, 0) },
      lines: [
        line([0, -0.9], [0, 0.3], COLORS.blue),
        line([0, 0.3], [1, 0.7], COLORS.orange),
        line([0, 0.3], [-1, 0.7], COLORS.orange),
        line([1, 0.7], [0.7, 0.2], COLORS.orange),
        line([-1, 0.7], [-0.7, 0.2], COLORS.orange),
        line([0.7, 0.2], [0, -0.1], COLORS.orange),
        line([-0.7, 0.2], [0, -0.1], COLORS.orange),
      ],
      arrows: [
        {
          label: 'L',
          from: point(0, 0, 0),
          vector: () =>
            times(angularMomentum(world) as Required<typeof start.momentum>, 1.15 / lengthOf(start.momentum)),
          color: COLORS.violet,
        },
      ],
    };
  },
  plots: (plot) => [plot('Spin about the stem', 'ω, rad/s', { label: 'stepped', value: ({ spin }) => spin() })],
  checks: ({ largest }) => [
    {
      label: 'Time of two flips, 4 K(k)/p',
      unit: 's',
      exact: (values) => tumblingPeriod(momentsOf(values), spinOf(values)),
      tolerance: { relative: 1e-4 },
      at: { event: ({ spin }) => spin(), from: 1, to: 2 },
    },
    largest(30, 'Largest change of the energy, as a fraction', { exact: 0, absolute: 1e-10 }, ({ world, start }) =>
      Math.abs(energy(world).kinetic / start.energy - 1),
    ),
    largest(
      30,
      'Largest change of the angular momentum, as a fraction',
      { exact: 0, absolute: 1e-10 },
      ({ world, start: { momentum: L } }) => {
        const { x, y, z } = angularMomentum(world);
        return lengthOf(point(x - L.x, y - L.y, z - L.z)) / lengthOf(L);
      },
    ),
  ],
  tryThis: [
    'Make the nudge a hundred times smaller: the nut spins steadily for longer, and then turns over just as quickly.',
    'Bring the inertia about the stem near the largest one, 2.5: the body wobbles slowly and hardly flips.',
  ],
});
