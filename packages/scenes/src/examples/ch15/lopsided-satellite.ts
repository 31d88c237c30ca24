import {
  angularMomentum,
  boxInertia,
  createPhysicsWorld,
  energy,
  principalAxes,
  spawn,
  tensorOfParts,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Color } from '../picture.ts';
import { tumblingPeriod } from '../support/free-rotation.ts';
import { lengthOf } from '../support/read.ts';
import {
  boxEdges,
  dot,
  inverse,
  orientationOf,
  type Point3,
  plus,
  point,
  pointOn,
  rotate,
  times,
} from '../support/space.ts';

type Values = ValuesOf<'spin' | 'load' | 'height'>;

const DT = 1 / 120;
/** A flat box, kg and m, and how far out the boom holds the load. */
const BUS = { mass: 100, size: point(1.6, 0.6, 1.6) };
const BOOM = 1.6;
/** Upwards in the axes of the box; and in the principal axes that of the largest moment, which is the third, downwards. */
const AXIS_OF_BOX = point(0, 1, 0);
const STEADY = point(0, 0, -1);
const BUS_MOMENTS = boxInertia(BUS.mass, BUS.size);

const solidOf = ({ load, height }: Values) =>
  tensorOfParts([
    { mass: BUS.mass, inertia: BUS_MOMENTS },
    { mass: load, position: { x: BOOM, y: height } },
  ]);

/** Moments and tilt of the principal axes, which lie in the plane of the boom: the two roots of a quadratic equation. */
function exactAxes({ load, height }: Values): { moments: Point3; tilt: number } {
  const reduced = (load * BUS.mass) / (load + BUS.mass);
  const [xx, yy] = [BUS_MOMENTS.x + reduced * height * height, BUS_MOMENTS.y + reduced * BOOM * BOOM];
  const [half, product] = [(yy - xx) / 2, reduced * BOOM * height];
  const root = Math.sqrt(half * half + product * product);
  const middle = BUS_MOMENTS.z + reduced * (BOOM * BOOM + height * height);
  const moments = point((xx + yy) / 2 - root, middle, (xx + yy) / 2 + root);
  // tan α of tan 2α = product/half.
  return { moments, tilt: product / (half + root) };
}

/** Angular velocity in the principal axes: it is given about the axis of the box. */
function exactSpin(values: Values): Point3 {
  const { tilt } = exactAxes(values);
  const cosine = 1 / Math.sqrt(1 + tilt * tilt);
  return point(values.spin * tilt * cosine, 0, values.spin * cosine);
}

export default defineExample({
  id: 'ch15-lopsided-satellite',
  title: 'A satellite that wobbles',
  chapter: 15,
  tags: ['3D', 'rotation', 'inertia', 'space'],
  about:
    'The box would spin steadily about its own axis, the blue one. A load at the end of a boom above the middle tilts the principal axes: in the axes of the box the tensor of inertia has products. Set spinning about the axis of the box, the satellite wobbles, for the angular momentum L is not along the spin. Only about the orange axis, that of the largest moment, would it be steady.',
  dimensions: 3,
  duration: 30,
  parameters: {
    spin: { label: 'Spin', unit: 'rad/s', initial: 2, min: 0.5, max: 6 },
    load: { label: 'Load on the boom', unit: 'kg', initial: 4, min: 0.1, max: 6 },
    height: { label: 'Its height', unit: 'm', initial: 1, min: 0, max: 1.5 },
  },
  presets: [
    { label: 'A boom in the middle', values: { height: 0 } },
    { label: 'Heavy and high', values: { load: 6, height: 1.5 } },
  ],
  build(values: Values, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 4, integrator });
    const { mass, centre, tensor } = solidOf(values);
    const { inertia, orientation } = principalAxes(tensor);
    const satellite = spawn(world, {
      position: {},
      mass,
      orientation,
      inertiaTensor: inertia,
      angularVelocity: { y: values.spin },
    });
    // The body's own axes are the principal ones; the box stands askew in them.
    const toBody = inverse(orientation);
    const place = (local: Point3) =>
      pointOn(world, satellite, rotate(toBody, plus(local, times(point(centre.x, centre.y, centre.z), -1))));
    const turned = (axis: Point3) => rotate(orientationOf(world, satellite), axis);
    const { AngularVelocity: w } = world.components;
    const spinAbout = (axis: Point3) => dot(point(w.x[satellite], w.y[satellite], w.z[satellite]), turned(axis));
    const start = { energy: energy(world).kinetic, momentum: angularMomentum(world) };
    return { world, dt: DT, values, satellite, inertia, orientation, toBody, place, turned, spinAbout, start };
  },
  picture({ world, values: { height }, toBody, place, turned, start }) {
    const load = point(BOOM, height, 0);
    const line = (from: Point3, to: Point3, color: Color) => ({ from: () => place(from), to: () => place(to), color });
    const axis = (local: Point3) => () => times(turned(local), 1.8);
    return {
      view: { minX: -1.7, maxX: 1.7, minY: -1.2, maxY: 1.7, minZ: -1.2, maxZ: 1.2 },
      camera: { eye: point(3, 2.4, 6), target: point(0, 0, 0) },
      lines: [
        ...boxEdges(times(BUS.size, 0.5), place, COLORS.grey),
        ...boxEdges(point(0.1, 0.1, 0.1), (local) => place(plus(load, local)), COLORS.yellow),
        line(point(0, BUS.size.y / 2, 0), load, COLORS.grey),
      ],
      arrows: [
        { label: 'box', from: point(0, 0, 0), vector: axis(rotate(toBody, AXIS_OF_BOX)), color: COLORS.blue },
        { label: 'steady', from: point(0, 0, 0), vector: axis(STEADY), color: COLORS.orange },
        {
          label: 'L',
          from: point(0, 0, 0),
          vector: () => times(angularMomentum(world) as Point3, 2 / lengthOf(start.momentum)),
          color: COLORS.violet,
        },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Angular velocity in the principal axes',
      'ω, rad/s',
      { label: 'least moment', value: ({ spinAbout }) => spinAbout(point(1, 0, 0)) },
      { label: 'middle moment', value: ({ spinAbout }) => spinAbout(point(0, 1, 0)) },
    ),
  ],
  checks: ({ at, largest }) => [
    at(
      0,
      'Tilt of the steady axis from that of the box, tan 2α = 2 I_xy/(I_yy − I_xx)',
      { exact: (values) => exactAxes(values).tilt, relative: 1e-12 },
      ({ toBody }) => {
        const axisOfBox = rotate(toBody, AXIS_OF_BOX);
        return Math.abs(axisOfBox.x / axisOfBox.z);
      },
    ),
    {
      label: 'Period of the wobble, 4 K(k)/p',
      unit: 's',
      exact: (values) => tumblingPeriod(exactAxes(values).moments, exactSpin(values)),
      // Without a tilt nothing wobbles.
      holds: ({ height }) => height > 0,
      tolerance: { relative: 1e-4 },
      at: { event: ({ spinAbout }) => spinAbout(point(0, 1, 0)), from: 1, to: 2 },
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
    'Lower the load to the middle: the axis of the box is a principal axis again, and nothing wobbles.',
    'Make the load heavier: the steady axis leans further, and the box swings about it.',
  ],
});
