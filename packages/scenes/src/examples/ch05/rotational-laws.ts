import {
  angularMomentum,
  constantTorque,
  cos,
  createPhysicsWorld,
  keepState,
  restrictForce,
  sin,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf } from '../support/read.ts';

const PUSH_TIME = 5;
const RADIUS = 1;
const DT = 1 / 60;

export default defineExample({
  id: 'ch05-rotational-laws',
  title: 'Newton’s laws for wheels',
  chapter: 5,
  tags: ['rotation', 'torque', 'angular momentum'],
  about:
    'A torque turns both wheels for five seconds, and then lets them go. What force and mass are for a push, torque and moment of inertia are for a turn: the angular acceleration is τ/I, and so the wheel with half of the inertia turns twice as fast. Without a torque, each keeps its turning for ever.',
  duration: 15,
  parameters: {
    torque: { label: 'Torque τ', unit: 'N m', initial: 1, min: -3, max: 3 },
    inertia: { label: 'Moment of inertia I', unit: 'kg m²', initial: 5, min: 1, max: 10 },
  },
  presets: [{ label: 'A heavy wheel', values: { inertia: 10 } }],
  build({ torque, inertia }: ValuesOf<'torque' | 'inertia'>, { integrator = velocityVerlet }: BuildOptions) {
    // Half a step less: 300 steps, wherever the sum of 300 sixtieths is rounded to.
    const push = restrictForce(constantTorque({ z: torque }), { until: PUSH_TIME - DT / 2 });
    const world = createPhysicsWorld({ capacity: 4, forces: [push], integrator });
    const wheel = { velocity: {}, mass: 1, rotation: {}, angularVelocity: {} };
    const ball = spawn(world, { ...wheel, position: { x: -1.3 }, inertia });
    const light = spawn(world, { ...wheel, position: { x: 1.3 }, inertia: inertia / 2 });
    // The angular momentum soon after the push.
    const log = { atEnd: 0 };
    keepState(world, log);
    world.phases.events.push(() => {
      if (world.time < PUSH_TIME + 0.5) log.atEnd = angularMomentum(world).z;
    });
    return { world, dt: DT, ball, light, log };
  },
  picture({ world, ball, light }, { torque }) {
    const { Rotation } = world.components;
    const spokes = [ball, light].flatMap((id) =>
      [0, 1, 2].map((i) => {
        const end = (side: number) => () => {
          const angle = Rotation.angle[id] + (i * Math.PI) / 3;
          const { x, y } = positionOf(world, id);
          return { x: x + side * RADIUS * cos(angle), y: y + side * RADIUS * sin(angle) };
        };
        return { from: end(-1), to: end(1), color: COLORS.white, width: 3 };
      }),
    );
    return {
      view: { minX: -3, maxX: 3, minY: -1.7, maxY: 1.9 },
      fills: [ball, light].map((id, i) => ({
        shape: { centre: { x: positionOf(world, id).x, y: 0 }, radius: RADIUS },
        color: [COLORS.blue, COLORS.orange][i],
        opacity: 0.6,
      })),
      arrows: [ball, light].map((id) => ({
        label: 'push',
        from: () => ({ x: positionOf(world, id).x + RADIUS, y: 0 }),
        vector: () => ({ x: 0, y: world.time < PUSH_TIME ? torque : 0 }),
        scale: 0.6,
        color: COLORS.red,
      })),
      labels: [
        { at: { x: -1.8, y: -1.5 }, text: 'inertia I' },
        { at: { x: 0.9, y: -1.5 }, text: 'half of it' },
      ],
      lines: spokes,
    };
  },
  plots: (plot) => [
    plot(
      'Angular velocity',
      'ω, rad/s',
      {
        label: 'inertia I',
        value: ({ world, ball }) => world.components.AngularVelocity.z[ball],
        exact: (t, { torque, inertia }) => (torque / inertia) * Math.min(t, PUSH_TIME),
      },
      { label: 'half of it', value: ({ world, light }) => world.components.AngularVelocity.z[light] },
    ),
  ],
  checks: ({ at }) => [
    at(
      1,
      'Angular velocity after 1 s, τ t/I',
      { exact: ({ torque, inertia }) => torque / inertia, unit: 'rad/s', absolute: 1e-14 },
      ({ world, ball }) => world.components.AngularVelocity.z[ball],
    ),
    at(
      6,
      'Angular momentum of both after the push, 2 τ t',
      { exact: ({ torque }) => 2 * torque * PUSH_TIME, unit: 'kg m²/s', absolute: 1e-12 },
      ({ world }) => angularMomentum(world).z,
    ),
    at(
      15,
      'Its change in the ten seconds after the push',
      { exact: 0, unit: 'kg m²/s', absolute: 1e-14 },
      ({ world, log }) => angularMomentum(world).z - log.atEnd,
    ),
  ],
  tryThis: [
    'Make the wheels heavier: after the same push they turn more slowly, but their angular momentum is the same.',
    'Turn the torque round: so do the wheels.',
  ],
});
