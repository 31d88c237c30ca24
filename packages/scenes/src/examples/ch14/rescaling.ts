import { attractors, createPhysicsWorld, type Integrator, rgba, rungeKutta4, spawn, step } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

/** The astronomical unit, m, a year, s, and the gravitational parameter of the sun, m³/s². */
const AU = 1.495978707e11;
const YEAR = 3.15576e7;
const MU = 1.32712440018e20;
const STEPS = 500;

/** A planet at the distance of the Earth, in units of so many metres and seconds. */
function orbit(length: number, time: number, speed: number, integrator: Integrator) {
  const mu = (MU * time * time) / (length * length * length);
  const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
  spawn(world, { position: {}, attractor: mu, appearance: { size: 0.09, color: rgba(1, 0.8, 0.3) } });
  const velocity = { y: (1000 * speed * time) / length };
  const ball = spawn(world, { position: { x: AU / length }, velocity, mass: 1, collider: 0.04 });
  return { world, ball };
}

/** The places after each step of a year in metres and seconds, in astronomical units. */
function recordInMetres(speed: number, integrator: Integrator): Point[] {
  const { world, ball } = orbit(1, 1, speed, integrator);
  const path: Point[] = [];
  for (let i = 0; i <= 2 * STEPS; i++) {
    const { x, y } = positionOf(world, ball);
    path.push({ x: x / AU, y: y / AU });
    step(world, YEAR / STEPS);
  }
  return path;
}

export default defineExample({
  id: 'ch14-rescaling',
  title: 'Metres or astronomical units?',
  chapter: 14,
  tags: ['units', 'orbit', 'scale'],
  about:
    'The distance to the sun is 150 000 000 000 m, and a year has 31 557 600 s. Whoever counts in astronomical units and years instead gets handy numbers near 1, and the same orbit. One only has to convert everything: lengths, velocities by length over time, and GM by length³ over time². The ring was computed in metres and seconds.',
  duration: 2,
  parameters: { speed: { label: 'Speed at the start', unit: 'km/s', initial: 30, min: 22, max: 36 } },
  presets: [{ label: 'A long ellipse', values: { speed: 36 } }],
  build({ speed }: ValuesOf<'speed'>, { integrator = rungeKutta4 }: BuildOptions) {
    const path = recordInMetres(speed, integrator);
    const { world, ball } = orbit(AU, YEAR, speed, integrator);
    const inMetres = (time: number) => path[Math.min(path.length - 1, Math.round(time * STEPS))];
    return { world, dt: 1 / STEPS, ball, inMetres };
  },
  picture: ({ world, ball, inMetres }) => ({
    view: { minX: -2.9, maxX: 1.5, minY: -1.5, maxY: 1.5 },
    trails: [{ body: ball, length: 500 }],
    curves: [{ points: [], now: inMetres, markRadius: 0.06, label: 'in metres', color: COLORS.orange }],
    arrows: [velocityArrow(world, ball, 0.08)],
  }),
  plots: [
    {
      title: 'Distance from the sun',
      x: { label: 't, years', value: ({ world }) => world.time },
      y: { label: 'r, astronomical units' },
      series: [
        { label: 'distance', value: ({ world, ball }) => distanceBetween(positionOf(world, ball), { x: 0, y: 0 }) },
      ],
    },
  ],
  checks: ({ at }) => [
    at(
      1,
      'Distance of the two computations after a year',
      { exact: 0, unit: 'au', absolute: 1e-12 },
      ({ world, ball, inMetres }) => distanceBetween(positionOf(world, ball), inMetres(world.time)),
    ),
    at(
      0,
      'Speed of the start in astronomical units per year',
      { exact: ({ speed }) => (1000 * speed * YEAR) / AU, unit: 'au/yr', relative: 1e-12 },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
  ],
  tryThis: [
    'A speed of 29.8 km/s makes a circle: the distance in the plot is then a level line.',
    'Start at 36 km/s: the planet goes far out, and is not back after two years.',
  ],
});
