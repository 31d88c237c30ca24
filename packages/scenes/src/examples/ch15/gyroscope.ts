import { axial3, createPhysicsWorld, defineLaw, scalar, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Line } from '../picture.ts';
import { orientationOf, point, pointOn, rotate, rotationAbout, times } from '../support/space.ts';

type Values = ValuesOf<'spin' | 'arm' | 'start'>;

const GRAVITY = 9.81;
/** A wheel of bicycle size, kg and m. */
const MASS = 2;
const RADIUS = 0.3;
const UP = point(0, 1, 0);

/** Of a thin hoop about its axle, and about a pivot on the axle at the distance of the arm, kg m². */
const aboutAxle = MASS * RADIUS * RADIUS;
const aboutPivot = (arm: number) => aboutAxle / 2 + MASS * arm * arm;

/** Rate of the steady precession of a level axle, rad/s. */
const precession = ({ spin, arm }: Values) => (MASS * GRAVITY * arm) / (aboutAxle * spin);

/** Lowest height of the wheel after its axle was let go level, m: the turning point of the nutation, u² − k u − 1 = 0. */
function lowestPoint({ spin, arm }: Values): number {
  const momentum = aboutAxle * spin;
  const k = (momentum * momentum) / (2 * aboutPivot(arm) * MASS * GRAVITY * arm);
  return (arm * (k - Math.sqrt(k * k + 4))) / 2;
}

/** The weight on an arm along the axle about a pivot at the origin, which holds the body: τ = (R r ẑ) × m g. */
const weightOnArm = defineLaw({
  name: 'weight on an arm',
  formula: 'τ = R r × m g',
  parameters: { arm: scalar('m'), gravity: scalar('m/s²') },
  torque({ rotate: turn, mass }, { arm, gravity }) {
    const { x, z } = turn(axial3(0, 0, 1));
    return axial3(z, 0, x.negate()).mul(mass.mul(gravity).mul(arm));
  },
});

export default defineExample({
  id: 'ch15-gyroscope',
  title: 'The wheel that does not fall',
  chapter: 15,
  tags: ['3D', 'rotation', 'gyroscope', 'precession'],
  about:
    'One end of the axle of a spinning wheel hangs on a string. Its weight does not tip it over: the torque is level, so it turns the angular momentum sideways, and the wheel walks about the string at the rate m g r/(I ω). Let go at rest, it dips a little, and nods as it walks.',
  dimensions: 3,
  duration: 16,
  parameters: {
    spin: { label: 'Spin of the wheel', unit: 'rad/s', initial: 30, min: 10, max: 60 },
    arm: { label: 'Distance r of the wheel', unit: 'm', initial: 0.25, min: 0.1, max: 0.4 },
    start: choiceOf('At the start', ['walking', 'let go']),
  },
  presets: [{ label: 'Let go', values: { start: 1 } }],
  build(values: Values, { integrator = velocityVerlet }: BuildOptions) {
    const { spin, arm, start } = values;
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 4,
      integrator,
      forces: [weightOnArm({ arm, gravity: GRAVITY })],
    });
    const across = aboutPivot(arm);
    const wheel = spawn(world, {
      position: {},
      mass: MASS,
      orientation: {},
      inertiaTensor: { x: across, y: across, z: aboutAxle },
      angularVelocity: { y: start === 0 ? precession(values) : 0, z: spin },
    });
    const axle = () => rotate(orientationOf(world, wheel), point(0, 0, 1));
    return { world, dt: 1 / 480, wheel, arm, axle };
  },
  picture({ world, wheel, axle }, { arm }) {
    const spokes = 24;
    const rim = (i: number) => {
      const { x, y } = rotate(rotationAbout(point(0, 0, 1), (2 * Math.PI * i) / spokes), point(RADIUS, 0, 0));
      return pointOn(world, wheel, point(x, y, arm));
    };
    const lines: Line[] = [
      { from: point(0, 0.7, 0), to: point(0, 0, 0), color: COLORS.grey },
      { from: point(0, 0, 0), to: () => times(axle(), 1.3 * arm), width: 4 },
    ];
    for (let i = 0; i < spokes; i++) {
      lines.push({ from: () => rim(i), to: () => rim(i + 1), color: COLORS.orange, width: 4 });
      if (i % 6 === 0) lines.push({ from: () => times(axle(), arm), to: () => rim(i), color: COLORS.orange });
    }
    return {
      view: { minX: -0.65, maxX: 0.65, minY: -0.45, maxY: 0.7, minZ: -0.65, maxZ: 0.65 },
      camera: { eye: point(2, 2, 5), target: point(0, 0, 0) },
      lines,
      arrows: [
        { label: 'L', from: point(0, 0, 0), vector: () => times(axle(), 1.9 * arm), color: COLORS.violet },
        {
          label: 'm g',
          from: () => times(axle(), arm),
          vector: () => times(UP, -0.25),
          color: COLORS.red,
        },
      ],
    };
  },
  plots: (plot) => [
    plot('Height of the wheel', 'y, m', { label: 'stepped', value: ({ axle, arm }) => arm * axle().y }),
  ],
  checks: ({ smallest }) => [
    {
      label: 'Time of one walk around, 2π I ω/(m g r)',
      unit: 's',
      exact: (values) => (2 * Math.PI) / precession(values),
      // Let go, it nods as it walks, and each walk takes a little longer or shorter.
      holds: ({ start }) => start === 0,
      // The nutation turns by at most I₃ ω dt/2I₁ = 0.03 in half a step, and errs by the twelfth part of its square.
      tolerance: { relative: 1e-3 },
      at: { event: ({ axle }) => axle().x, from: 1, to: 2 },
    },
    smallest(
      10,
      'Lowest point after letting go, r (k − √(k² + 4))/2',
      { exact: lowestPoint, unit: 'm', relative: 2e-3, preset: 'Let go' },
      ({ axle, arm }) => arm * axle().y,
    ),
  ],
  tryThis: [
    'Halve the spin: the wheel walks twice as fast. That is the wrong way round for anything that falls, and right here.',
    'Choose “let go” and a spin of 10 rad/s: the wheel dives, and its nodding comes to a stop at the start height each time.',
  ],
});
