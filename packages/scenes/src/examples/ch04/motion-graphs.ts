import { createPhysicsWorld, keepState, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'acceleration' | 'velocity'>;
const DT = 1 / 60;

export default defineExample({
  id: 'ch04-motion-graphs',
  title: 'Three graphs of one motion',
  chapter: 4,
  tags: ['acceleration', 'velocity', 'graph'],
  about:
    'A car accelerates evenly. The three graphs tell the same story: the slope of the distance is the velocity, the slope of the velocity is the acceleration, and the area under the velocity is the distance. Whoever knows one of the graphs can draw the other two.',
  duration: 8,
  ends: true,
  parameters: {
    acceleration: { label: 'Acceleration', unit: 'm/s²', initial: 3, min: -4, max: 6 },
    velocity: { label: 'Velocity at the start', unit: 'm/s', initial: 5, min: 0, max: 20 },
  },
  presets: [{ label: 'Braking and going back', values: { acceleration: -4, velocity: 16 } }],
  build({ acceleration, velocity }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ x: acceleration })], integrator });
    const ball = spawn(world, { position: {}, velocity: { x: velocity }, mass: 1, collider: 4 });
    // What can be computed from the way of the step before, and from the sum of all velocities so far.
    const log = { lastWay: 0, way: 0, lastVelocity: velocity, area: 0 };
    keepState(world, log);
    world.phases.events.push(() => {
      const [way, v] = [positionOf(world, ball).x, velocityOf(world, ball).x];
      log.lastWay = log.way;
      log.way = way;
      log.area += ((log.lastVelocity + v) / 2) * DT;
      log.lastVelocity = v;
    });
    const slope = () => (world.tick === 0 ? velocity : (log.way - log.lastWay) / DT);
    return { world, dt: DT, ball, log, slope };
  },
  picture: ({ world, ball }, { velocity, acceleration }) => ({
    view: { minX: -20, maxX: 150, minY: -30, maxY: 50 },
    fills: [{ shape: { minX: -1000, maxX: 1000, minY: -200, maxY: -4 }, color: COLORS.ground }],
    dots: Array.from({ length: 9 }, (_, t) => ({
      at: { x: velocity * t + (acceleration / 2) * t * t, y: -8 },
      radius: 4,
      color: COLORS.yellow,
    })),
    arrows: [
      velocityArrow(world, ball, 1),
      {
        label: 'a',
        from: () => ({ x: positionOf(world, ball).x, y: 12 }),
        vector: () => ({ x: acceleration, y: 0 }),
        scale: 3,
        color: COLORS.red,
      },
    ],
    labels: [{ at: { x: -18, y: -16 }, text: 'the dots are a second apart', color: COLORS.yellow }],
  }),
  plots: (plot) => [
    plot('Distance', 's, m', {
      label: 's',
      value: ({ world, ball }) => positionOf(world, ball).x,
      exact: (t, { velocity, acceleration }) => velocity * t + (acceleration / 2) * t * t,
    }),
    plot(
      'Velocity, and slope of the distance',
      'v, m/s',
      { label: 'v', value: ({ world, ball }) => velocityOf(world, ball).x },
      { label: 'slope', value: ({ slope }) => slope() },
    ),
  ],
  checks: ({ at }) => [
    // The slope over the last step is the velocity in its middle.
    at(
      4,
      'Slope of the distance less velocity after 4 s, −a dt/2',
      { exact: ({ acceleration }) => (-acceleration * DT) / 2, unit: 'm/s', absolute: 1e-9 },
      ({ world, ball, slope }) => slope() - velocityOf(world, ball).x,
    ),
    at(
      8,
      'Area under the velocity less distance after 8 s',
      { exact: 0, unit: 'm', absolute: 1e-9 },
      ({ world, ball, log }) => log.area - positionOf(world, ball).x,
    ),
  ],
  tryThis: [
    'Choose the braking car: where the velocity goes through 0, the distance has its highest point.',
    'Set the acceleration to 0: the graph of the distance becomes a straight line.',
  ],
});
