import { exp, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { lengthOf } from '../support/read.ts';
import { inverse, normOf, orientationOf, point, product, rotationAbout, times } from '../support/space.ts';
import { cubeLines, PUSH_TIME, turningCube } from '../support/turning-cube.ts';

type Values = ValuesOf<'x' | 'y' | 'z'>;

/** Angle after 10 s of a torque of √3 about the diagonal against a drag of 0.5, rad: 2√3 (t − 2 (1 − e^(−t/2))). */
const TURNED = 2 * Math.sqrt(3) * (10 - 2 * (1 - exp(-5)));

export default defineExample({
  id: 'ch15-cube-quaternion',
  title: 'Turning about any axis',
  chapter: 15,
  tags: ['3D', 'rotation', 'quaternion'],
  about:
    'The torque points along a diagonal, so the cube turns about its diagonal. Its orientation is kept as a quaternion, four numbers whose squares sum to 1. They know no forbidden directions, unlike three angles, and are easily put right again when rounding has made their sum a little wrong.',
  dimensions: 3,
  duration: 20,
  parameters: {
    x: { label: 'Torque to the right', unit: 'N m', initial: 1, min: -2, max: 2 },
    y: { label: 'Torque upwards', unit: 'N m', initial: 1, min: -2, max: 2 },
    z: { label: 'Torque to the front', unit: 'N m', initial: 1, min: -2, max: 2 },
  },
  presets: [{ label: 'About the upright axis', values: { x: 0, z: 0 } }],
  build({ x, y, z }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const run = turningCube({ torque: { x, y, z }, drag: 0.5, inertia: 1, pushTime: PUSH_TIME, integrator });
    const omega = () => {
      const { AngularVelocity: w } = run.world.components;
      return point(w.x[run.cube], w.y[run.cube], w.z[run.cube]);
    };
    return { ...run, omega };
  },
  picture: (run, { x, y, z }) => ({
    view: { minX: -130, maxX: 130, minY: -110, maxY: 110, minZ: -100, maxZ: 100 },
    lines: cubeLines(run, COLORS.green),
    arrows: [
      { label: 'ω', from: point(0, 0, 0), vector: () => times(run.omega(), 30), color: COLORS.yellow },
      {
        label: 'τ',
        from: point(0, 0, 0),
        vector: () => (run.isOn() ? point(60 * x, 60 * y, 60 * z) : point(0, 0, 0)),
        color: COLORS.red,
      },
    ],
  }),
  actions: {
    action: {
      label: 'Turn',
      about: 'turn the cube',
      key: 't',
      press: ({ switches }) => void Object.assign(switches, { byKey: true }),
      release: ({ switches }) => void Object.assign(switches, { byKey: false }),
    },
  },
  pointer: 'action',
  plots: (plot) => [
    plot('Angular velocity', '∣ω∣, rad/s', { label: 'stepped', value: ({ omega }) => lengthOf(omega()) }),
  ],
  checks: ({ at, largest }) => [
    at(
      10,
      'Angular velocity after 10 s, 2√3 (1 − e⁻⁵)',
      { exact: ({ x, y, z }) => 2 * (1 - exp(-5)) * lengthOf({ x, y, z }), unit: 'rad/s', relative: 1e-3 },
      ({ omega }) => lengthOf(omega()),
    ),
    largest(10, 'Largest difference of the parts of ω', { exact: 0, unit: 'rad/s', absolute: 1e-12 }, ({ omega }) =>
      Math.max(Math.abs(omega().x - omega().y), Math.abs(omega().y - omega().z)),
    ),
    at(
      10,
      'Angle from the exact turn about the diagonal after 10 s, by that of 27.76 rad',
      { exact: 0, absolute: 1e-3 },
      ({ world, cube }) => {
        const left = product(inverse(rotationAbout(point(1, 1, 1), TURNED)), orientationOf(world, cube));
        return (2 * lengthOf(left)) / TURNED;
      },
    ),
    at(20, 'Norm of the quaternion after 20 s', { exact: 1, absolute: 1e-14 }, ({ world, cube }) =>
      normOf(orientationOf(world, cube)),
    ),
  ],
  tryThis: [
    'Choose the upright axis: four edges stay upright, and the cube turns like a carousel.',
    'Give two torques opposite signs: the yellow axis points to another edge or corner.',
  ],
});
