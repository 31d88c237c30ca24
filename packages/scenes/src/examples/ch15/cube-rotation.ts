import { atan2, exp, keepState, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { orientationOf, point } from '../support/space.ts';
import { cubeLines, PUSH_TIME, turningCube } from '../support/turning-cube.ts';

type Values = ValuesOf<'torque' | 'drag' | 'inertia'>;
const exactSpeed = (t: number, { torque, drag, inertia }: Values) => {
  const pushed = (torque / drag) * (1 - exp((-drag * Math.min(t, PUSH_TIME)) / inertia));
  return pushed * exp((-drag * Math.max(0, t - PUSH_TIME)) / inertia);
};

export default defineExample({
  id: 'ch15-cube-rotation',
  title: 'Spinning up a cube',
  chapter: 15,
  tags: ['3D', 'rotation', 'torque'],
  about:
    'For ten seconds a torque turns the cube about the horizontal axis, while the air brakes it harder the faster it turns. It comes to an angular velocity of τ/k, just as a falling stone comes to its terminal velocity. Then the torque is off, and the cube slows down. Hold T or press the picture to turn it again.',
  dimensions: 3,
  duration: 20,
  parameters: {
    torque: { label: 'Torque τ', unit: 'N m', initial: 2, min: 0, max: 6 },
    drag: { label: 'Drag k', unit: 'N m s', initial: 0.5, min: 0.1, max: 2 },
    inertia: { label: 'Moment of inertia', unit: 'kg m²', initial: 1, min: 0.5, max: 4 },
  },
  presets: [{ label: 'A heavy cube', values: { inertia: 4 } }],
  build({ torque, drag, inertia }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const run = turningCube({ torque: { x: torque, y: 0 }, drag, inertia, pushTime: PUSH_TIME, integrator });
    // The angle of all turns so far, from the changes of the orientation.
    const turned = { angle: 0, last: 0 };
    keepState(run.world, turned);
    run.world.phases.events.push(() => {
      const q = orientationOf(run.world, run.cube);
      const angle = 2 * atan2(q.x, q.w);
      const change = angle - turned.last;
      turned.angle += change - 2 * Math.PI * Math.round(change / (2 * Math.PI));
      turned.last = angle;
    });
    return { ...run, turned };
  },
  picture: (run) => ({
    view: { minX: -130, maxX: 130, minY: -110, maxY: 110, minZ: -100, maxZ: 100 },
    lines: [...cubeLines(run), { from: point(-120, 0, 0), to: point(120, 0, 0), color: COLORS.grey }],
    arrows: [{ label: 'τ', from: point(0, 0, 0), vector: () => point(run.isOn() ? 100 : 0, 0, 0), color: COLORS.red }],
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
    plot('Angular velocity', 'ω, rad/s', {
      label: 'stepped',
      value: ({ world, cube }) => world.components.AngularVelocity.x[cube],
      exact: exactSpeed,
    }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Angular velocity after 10 s, τ/k (1 − e^(−kt/I))',
      { exact: (values) => exactSpeed(10, values), unit: 'rad/s', relative: 1e-3 },
      ({ world, cube }) => world.components.AngularVelocity.x[cube],
    ),
    // Semi-implicit Euler is ahead by 4 dt = 0.017 rad at 240 steps per second.
    at(10, 'Angle after 10 s', { exact: 32.054, unit: 'rad', relative: 1e-3 }, ({ turned }) => turned.angle),
  ],
  tryThis: [
    'Make the cube heavier: it comes to the same angular velocity in the end, but takes longer.',
    'Halve the drag: it turns twice as fast in the end.',
  ],
});
