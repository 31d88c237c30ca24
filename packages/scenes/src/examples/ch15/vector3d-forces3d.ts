import { cos, sin } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { emptyWorld, lengthOf } from '../support/read.ts';
import { cross, dot, type Point3, plus, point } from '../support/space.ts';

const ORIGIN = point(0, 0, 0);

export default defineExample({
  id: 'ch15-vector3d-forces3d',
  title: 'At right angles to both',
  chapter: 15,
  tags: ['3D', 'vectors'],
  about:
    'Two arrows in space, blue and orange, always have a third one that stands at right angles to both: their cross product, in green. Its length is the area of the parallelogram between them. Physics needs it wherever something turns: torque, angular momentum, and the force on a charge in a magnetic field.',
  dimensions: 3,
  duration: 12,
  parameters: {
    height: { label: 'Height of the orange tip', initial: 0.5, min: -2, max: 2 },
    rate: { label: 'Turning of the orange arrow', unit: '°/s', initial: 30, min: 0, max: 120 },
  },
  presets: [{ label: 'Both in the plane', values: { height: 0 } }],
  build({ height, rate }: ValuesOf<'height' | 'rate'>) {
    const world = emptyWorld(3);
    const a = point(1.5, 0, 0);
    const b = () => {
      const angle = (rate * world.time * Math.PI) / 180;
      return point(1.2 * cos(angle), height, -1.2 * sin(angle));
    };
    return { world, dt: 1 / 60, a, b, c: () => cross(a, b()) };
  },
  picture({ a, b, c }) {
    const corner = () => plus(a, b());
    const ring = (y: number): Point3[] =>
      Array.from({ length: 73 }, (_, i) => point(1.2 * cos((i * Math.PI) / 36), y, 1.2 * sin((i * Math.PI) / 36)));
    return {
      view: { minX: -2, maxX: 2.6, minY: -1.6, maxY: 2.2, minZ: -1.6, maxZ: 1.6 },
      curves: [{ points: ring(0), color: COLORS.ground }],
      lines: [
        { from: a, to: corner, color: COLORS.grey },
        { from: b, to: corner, color: COLORS.grey },
      ],
      arrows: [
        { label: 'a', from: ORIGIN, vector: () => a, color: COLORS.blue },
        { label: 'b', from: ORIGIN, vector: b, color: COLORS.orange },
        { label: 'a × b', from: ORIGIN, vector: c, color: COLORS.green },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Dot product, and length of the cross product',
      'product',
      { label: 'a·b', value: ({ a, b }) => dot(a, b()) },
      { label: '∣a × b∣', value: ({ c }) => lengthOf(c()) },
    ),
  ],
  checks: ({ at, largest }) => [
    largest(12, 'Largest dot product of a and a × b', { exact: 0, absolute: 1e-14 }, ({ a, c }) =>
      Math.abs(dot(a, c())),
    ),
    largest(12, 'Largest dot product of b and a × b', { exact: 0, absolute: 1e-14 }, ({ b, c }) =>
      Math.abs(dot(b(), c())),
    ),
    // Lagrange: |a × b|² + (a·b)² = |a|² |b|².
    largest(12, 'Largest error of ∣a × b∣² + (a·b)² = a² b²', { exact: 0, absolute: 1e-14 }, ({ a, b, c }) =>
      Math.abs(dot(c(), c()) + dot(a, b()) * dot(a, b()) - dot(a, a) * dot(b(), b())),
    ),
    at(0, 'i × j is k: its part along z', { exact: 1, absolute: 0 }, () => cross(point(1, 0, 0), point(0, 1, 0)).z),
  ],
  tryThis: [
    'Put both arrows into the plane: the green one then stands upright, up for half a turn and down for the other.',
    'Watch the plot: where the dot product is largest, the cross product is smallest.',
  ],
});
