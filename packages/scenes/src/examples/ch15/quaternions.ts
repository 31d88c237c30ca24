import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { distanceBetween, emptyWorld } from '../support/read.ts';
import {
  cubeEdges,
  normOf,
  type Point3,
  point,
  product,
  type Quaternion,
  rotate,
  rotationAbout,
  times,
} from '../support/space.ts';

const DEGREE = Math.PI / 180;

/** A million small turns one after the other; the norm is put right after each. */
function manyProducts(): Quaternion {
  const small = rotationAbout(point(1, 2, 3), 0.001);
  let q: Quaternion = { x: 0, y: 0, z: 0, w: 1 };
  for (let i = 0; i < 1_000_000; i++) {
    const next = product(small, q);
    const norm = normOf(next);
    q = { x: next.x / norm, y: next.y / norm, z: next.z / norm, w: next.w / norm };
  }
  return q;
}

export default defineExample({
  id: 'ch15-quaternions',
  title: 'Four numbers for a turn',
  chapter: 15,
  tags: ['3D', 'rotation', 'quaternion'],
  about:
    'Every rotation is a turn about some axis by some angle. A quaternion stores both in four numbers: the direction of the axis times sin θ/2, and cos θ/2. Two turns, one after the other, are the product of their quaternions. The cube turns about the yellow axis, and the orange point runs on a circle around it.',
  dimensions: 3,
  duration: 10,
  parameters: {
    x: { label: 'Axis, to the right', initial: 0, min: -1, max: 1 },
    y: { label: 'Axis, upwards', initial: 0, min: -1, max: 1 },
    z: { label: 'Axis, to the front', initial: 1, min: 0.1, max: 1 },
    rate: { label: 'Angle per second', unit: '°/s', initial: 45, min: 0, max: 180 },
  },
  presets: [{ label: 'About a corner', values: { x: 1, y: 1, z: 1 } }],
  build({ x, y, z, rate }: ValuesOf<'x' | 'y' | 'z' | 'rate'>) {
    const world = emptyWorld(3);
    const axis = point(x, y, z);
    const turn = () => rotationAbout(axis, rate * world.time * DEGREE);
    return { world, dt: 1 / 60, axis, turn, norm: normOf(manyProducts()) };
  },
  picture({ axis, turn }) {
    const tip = times(axis, 130 / Math.sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z));
    const place = (local: Point3) => rotate(turn(), local);
    const circle = Array.from({ length: 73 }, (_, i) => rotate(rotationAbout(axis, 5 * i * DEGREE), point(100, 0, 0)));
    return {
      view: { minX: -150, maxX: 150, minY: -120, maxY: 120, minZ: -120, maxZ: 120 },
      curves: [{ points: circle, color: COLORS.grey }],
      lines: [
        ...cubeEdges(50, place, COLORS.blue),
        { from: times(tip, -1), to: tip, color: COLORS.yellow },
        { from: point(0, 0, 0), to: () => place(point(100, 0, 0)), color: COLORS.orange },
      ],
      dots: [{ at: () => place(point(100, 0, 0)), color: COLORS.orange }],
    };
  },
  plots: (plot) => [
    plot(
      'The four numbers',
      'part',
      ...(['x', 'y', 'z', 'w'] as const).map((part) => ({
        label: part,
        value: ({ turn }: { turn(): Quaternion }) => turn()[part],
      })),
    ),
  ],
  checks: ({ at }) => [
    at(0, 'A turn by 90° about z takes (1, 0, 0) to (0, 1, 0): distance', { exact: 0, absolute: 1e-15 }, ({ axis }) =>
      distanceBetween(rotate(rotationAbout(axis, Math.PI / 2), point(1, 0, 0)), point(0, 1, 0)),
    ),
    at(1, 'Norm after a million products, put right after each', { exact: 1, absolute: 1e-15 }, ({ norm }) => norm),
    at(10, 'Norm of the turn after 10 s', { exact: 1, absolute: 1e-14 }, ({ turn }) => normOf(turn())),
  ],
  tryThis: [
    'Watch the four numbers: after a whole turn they have the other sign, and only after two turns are they back.',
    'Choose the corner: after a third of a turn the cube looks as it did at first.',
  ],
});
