import { cos, createPhysicsWorld, createRandom, sin, spawn, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { distanceBetween, positionOf, speedOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 250 };

export default defineExample({
  id: 'ch04-balls-move',
  title: 'All away from the middle',
  chapter: 4,
  tags: ['uniform motion', 'velocity', 'random numbers'],
  about:
    'Ten balls start in the middle with random velocities. Whoever is fast is far out: at any time each ball is at the distance v t. The galaxies of the universe do much the same, and so one can find out when they all were in one place.',
  duration: 10,
  parameters: {
    balls: { label: 'Number of balls', initial: 10, min: 2, max: 60, integer: true },
    speed: { label: 'Largest velocity per axis', unit: 'px/s', initial: 10, min: 2, max: 20 },
  },
  presets: [{ label: 'A swarm', values: { balls: 60, speed: 20 } }],
  build({ balls, speed }: ValuesOf<'balls' | 'speed'>, { seed, integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 64, integrator });
    const random = createRandom(seed);
    const ids = Array.from({ length: balls }, () => {
      const velocity = { x: random.uniform(-speed, speed), y: random.uniform(-speed, speed) };
      return spawn(world, { position: CENTRE, velocity, mass: 1, collider: random.uniform(5, 15) });
    });
    // How far the ball that misses its distance v t most is from it.
    const largestError = () =>
      Math.max(
        ...ids.map((id) => Math.abs(distanceBetween(positionOf(world, id), CENTRE) - speedOf(world, id) * world.time)),
      );
    const sumAlong = (read: typeof positionOf) => ids.reduce((sum, id) => sum + read(world, id).x, 0);
    const sumOfX = () => sumAlong(positionOf) - balls * CENTRE.x - world.time * sumAlong(velocityOf);
    return { world, dt: 1 / 60, ids, largestError, sumOfX };
  },
  picture: ({ world, ids }, { speed }) => ({
    yDown: true,
    view: { minX: 100, maxX: 600, minY: 90, maxY: 410 },
    trails: ids.map((body) => ({ body, length: 600 })),
    curves: [5, 10].map((t) => ({
      points: pointsOf(
        (angle) => ({ x: CENTRE.x + speed * t * cos(angle), y: CENTRE.y + speed * t * sin(angle) }),
        0,
        2 * Math.PI,
        120,
      ),
      color: COLORS.ground,
    })),
    arrows: ids.map((id) => ({
      label: '',
      from: () => positionOf(world, id),
      vector: () => velocityOf(world, id),
      scale: 3,
    })),
    labels: [5, 10].map((t) => ({
      at: { x: CENTRE.x, y: CENTRE.y - speed * t },
      text: `${speed} px/s after ${t} s`,
      color: COLORS.grey,
    })),
  }),
  plots: (plot) => [
    plot(
      'Distance from the middle',
      'distance, px',
      ...[0, 1].map((i) => ({
        label: `ball ${i + 1}`,
        value: ({ world, ids }: { world: Parameters<typeof positionOf>[0]; ids: readonly number[] }) =>
          distanceBetween(positionOf(world, ids[i]), CENTRE),
      })),
    ),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Largest difference of a distance and v t, after 10 s',
      { exact: 0, unit: 'px', absolute: 1e-9 },
      ({ largestError }) => largestError(),
    ),
    at(10, 'Sum of all x, less 10 · 350 + t Σv, after 10 s', { exact: 0, unit: 'px', absolute: 1e-8 }, ({ sumOfX }) =>
      sumOfX(),
    ),
  ],
  tryThis: [
    'Press rewind: the balls fly back into the middle, all at the same moment.',
    'Take sixty balls: they fill a square and not a disc, because each axis has its own limit.',
  ],
});
