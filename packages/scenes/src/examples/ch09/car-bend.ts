import { corneringGrip, cos, createPhysicsWorld, rgba, rungeKutta4, sin, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 200, y: 150 };
const [RADIUS, MASS, GRAVITY] = [75, 90, 10];
const ring = (radius: number) =>
  Array.from({ length: 60 }, (_, i) => {
    const [a, b] = [(i * Math.PI) / 30, ((i + 1) * Math.PI) / 30];
    return {
      from: { x: CENTRE.x + radius * cos(a), y: CENTRE.y + radius * sin(a) },
      to: { x: CENTRE.x + radius * cos(b), y: CENTRE.y + radius * sin(b) },
      color: COLORS.white,
    };
  });

export default defineExample({
  id: 'ch09-car-bend',
  title: 'Too fast for the roundabout?',
  chapter: 9,
  tags: ['circular motion', 'friction', 'centripetal force'],
  about:
    'To keep a car on a circle takes a force m v²/r towards the middle, and only the friction of the tyres can give it, at most μ m g. Up to v = √(μ g r), 27.4 px/s here, the car stays in its lane. Beyond that it slides outwards. The mass of the car does not matter.',
  duration: 48,
  parameters: {
    speed: { label: 'Speed', unit: 'px/s', initial: 10, min: 2, max: 40 },
    friction: { label: 'Friction μ', initial: 1, min: 0.1, max: 1.5 },
  },
  presets: [
    { label: 'Just slow enough', values: { speed: 27 } },
    { label: 'A little too fast', values: { speed: 28 } },
    { label: 'Ice', values: { friction: 0.1 } },
  ],
  build({ speed, friction }, { integrator = rungeKutta4 }) {
    const grip = corneringGrip({ centre: CENTRE, friction, gravity: GRAVITY });
    const world = createPhysicsWorld({ capacity: 4, forces: [grip], integrator });
    const position = { x: CENTRE.x + RADIUS, y: CENTRE.y };
    const appearance = { size: 4, color: rgba(0.4, 0.7, 1) };
    const car = spawn(world, { position, velocity: { y: speed }, mass: MASS, appearance });
    return { world, dt: 1 / 240, car, radius: () => distanceBetween(positionOf(world, car), CENTRE) };
  },
  picture({ world, car, radius }, { friction }) {
    const force = (): Point => {
      const [{ x, y }, r, v] = [positionOf(world, car), radius(), speedOf(world, car)];
      const grip = Math.min((MASS * v * v) / r, friction * MASS * GRAVITY);
      return { x: (grip * (CENTRE.x - x)) / r, y: (grip * (CENTRE.y - y)) / r };
    };
    const along = (length: number) => () => {
      const [{ x, y }, v, speed] = [positionOf(world, car), velocityOf(world, car), speedOf(world, car)];
      return { x: x + (length * v.x) / speed, y: y + (length * v.y) / speed };
    };
    return {
      view: { minX: 40, maxX: 360, minY: 30, maxY: 270 },
      fills: [
        { shape: { centre: CENTRE, radius: 100 }, color: COLORS.ground },
        { shape: { centre: CENTRE, radius: 50 }, color: 0x2f6b45 },
      ],
      lines: [...ring(50), ...ring(100), { from: along(-7), to: along(7), width: 26, color: COLORS.blue }],
      trails: [{ body: car, length: 800, interval: 8 }],
      arrows: [forceArrow(world, car, 'friction', force, 0.06), velocityArrow(world, car, 1.2)],
    };
  },
  plots: (plot) => [
    plot('Distance from the middle', 'r, px', { label: 'car', value: ({ radius }) => radius() }),
    plot('Force', 'force, N', {
      label: 'needed',
      value: ({ world, car, radius }) => (MASS * speedOf(world, car) * speedOf(world, car)) / radius(),
      exact: (_, { friction }) => friction * MASS * GRAVITY,
    }),
  ],
  checks: ({ at, largest }) => [
    at(
      20,
      'Force that the circle needs, m v²/r',
      { exact: 120, unit: 'N', relative: 1e-9 },
      ({ world, car, radius }) => (MASS * speedOf(world, car) * speedOf(world, car)) / radius(),
    ),
    {
      label: 'Time for one round, 2πr/v',
      unit: 's',
      exact: 15 * Math.PI,
      tolerance: { absolute: 5e-4 },
      // The car starts on this line; it crosses it again at the end of the round.
      at: { event: ({ world, car }) => (world.time > 1 ? positionOf(world, car).y - CENTRE.y : -1), count: 2 },
    },
    largest(
      20,
      'Largest distance in 20 s at 27 px/s',
      { exact: RADIUS, unit: 'px', absolute: 0.05, preset: 'Just slow enough' },
      ({ radius }) => radius(),
    ),
    at(
      20,
      'Distance after 20 s at 28 px/s',
      { exact: 87.7, unit: 'px', absolute: 0.05, preset: 'A little too fast' },
      ({ radius }) => radius(),
    ),
  ],
  tryThis: [
    'Find the speed at which the car just stays in its lane; then halve the friction and find it again.',
    'Choose “Ice” and drive slower than 8.6 px/s: the car makes the bend.',
  ],
});
