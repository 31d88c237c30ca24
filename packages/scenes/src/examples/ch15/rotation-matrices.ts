import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import {
  apply,
  determinant,
  difference,
  type Matrix,
  multiply,
  orthogonalityError,
  rotationMatrix,
} from '../support/matrix.ts';
import { emptyWorld } from '../support/read.ts';
import { cubeEdges, type Point3, plus, point } from '../support/space.ts';

const RIGHT = Math.PI / 2;
const [LEFT_CUBE, RIGHT_CUBE] = [point(-110, 0, 0), point(110, 0, 0)];

/** Yaw about y, then pitch about x, then roll about z, as an aeroplane counts its angles from the outside inwards. */
const attitude = (yaw: number, pitch: number, roll: number) =>
  multiply(rotationMatrix('y', yaw), multiply(rotationMatrix('x', pitch), rotationMatrix('z', roll)));

export default defineExample({
  id: 'ch15-rotation-matrices',
  title: 'First right, then up?',
  chapter: 15,
  tags: ['3D', 'rotation', 'matrices'],
  about:
    'Both cubes make the same two turns by 90°, the left one first about the x axis and then about the y axis, the right one the other way round. In the end their orange, green and violet axes point in different directions: rotations in space do not commute: their order matters. Try it with a book!',
  dimensions: 3,
  duration: 8,
  parameters: {
    first: { label: 'Turn about the x axis', unit: '°', initial: 90, min: 0, max: 180 },
    second: { label: 'Turn about the y axis', unit: '°', initial: 90, min: 0, max: 180 },
  },
  presets: [{ label: 'Small turns', values: { first: 5, second: 5 } }],
  build({ first, second }: ValuesOf<'first' | 'second'>) {
    const world = emptyWorld(3);
    const [aboutX, aboutY] = [(first * Math.PI) / 180, (second * Math.PI) / 180];
    // The first turn takes the seconds 1 to 3, the second one 4 to 6.
    const share = (from: number) => Math.max(0, Math.min(1, (world.time - from) / 2));
    const left = () => multiply(rotationMatrix('y', aboutY * share(4)), rotationMatrix('x', aboutX * share(1)));
    const right = () => multiply(rotationMatrix('x', aboutX * share(4)), rotationMatrix('y', aboutY * share(1)));
    return { world, dt: 1 / 60, left, right };
  },
  picture({ left, right }) {
    const cube = (centre: Point3, turn: () => Matrix) => {
      const place = (local: Point3) => plus(centre, apply(turn(), local));
      const axis = (tip: Point3, color: number) => ({ from: () => place(point(0, 0, 0)), to: () => place(tip), color });
      return [
        ...cubeEdges(50, place, COLORS.blue),
        axis(point(85, 0, 0), COLORS.orange),
        axis(point(0, 85, 0), COLORS.green),
        axis(point(0, 0, 85), COLORS.violet),
      ];
    };
    return {
      view: { minX: -210, maxX: 210, minY: -120, maxY: 120, minZ: -100, maxZ: 100 },
      lines: [...cube(LEFT_CUBE, left), ...cube(RIGHT_CUBE, right)],
    };
  },
  plots: (plot) => [
    plot('How much the two orientations differ', 'largest element of the difference', {
      label: 'difference',
      value: ({ left, right }) => difference(left(), right()),
    }),
  ],
  checks: ({ at, largest }) => [
    largest(
      8,
      'Lengths and right angles that a rotation keeps: largest error',
      { exact: 0, absolute: 1e-14 },
      ({ left }) => orthogonalityError(left()),
    ),
    at(8, 'Determinant, the volume that it keeps', { exact: 1, absolute: 1e-14 }, ({ left }) => determinant(left())),
    at(8, 'Difference of the two orders', { exact: 1, absolute: 1e-14 }, ({ left, right }) =>
      difference(left(), right()),
    ),
    // With the nose straight down, yaw and roll turn about the same axis: only their difference counts.
    at(0, 'Gimbal lock: yaw 30° and roll 30° at pitch 90°, less none of both', { exact: 0, absolute: 1e-14 }, () =>
      difference(attitude(RIGHT / 3, RIGHT, RIGHT / 3), attitude(0, RIGHT, 0)),
    ),
  ],
  tryThis: [
    'Take small turns of 5°: the two orders hardly differ, and less and less the smaller the turns are.',
    'Make one of the turns 0°: the order no longer matters, and both cubes agree.',
  ],
});
