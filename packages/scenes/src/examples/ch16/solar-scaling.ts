import { attractors, createPhysicsWorld, rgba, rungeKutta4, spawn } from '@principia/physics';
import { type BuildOptions, defineExample } from '../define-example.ts';
import { lengthOf, positionOf, velocityOf } from '../support/read.ts';
import { BOOK, BOOK_PLANETS } from '../support/solar.ts';

/** The units: mass of the Earth, kg, a day, s, and 10⁹ m. */
const [MASS, TIME, LENGTH] = [BOOK.earth, 86400, 1e9];
const G = (BOOK.G * MASS * TIME * TIME) / (LENGTH * LENGTH * LENGTH);
const SUN = BOOK.sun / MASS;
const GM = G * SUN;
/** A unit of velocity, m/s. */
const SPEED = LENGTH / TIME;
const { distance, speed } = BOOK_PLANETS.earth;

export default defineExample({
  id: 'ch16-solar-scaling',
  title: 'Units for the solar system',
  chapter: 16,
  tags: ['units', 'orbit', 'scale'],
  about:
    'In kilograms, metres and seconds the solar system is full of powers of ten. With the mass of the Earth, a day and a million kilometres as units the Earth is 150 from the Sun and does 2.6 a day, and the Sun has the mass 333 000. The constant of gravity is then 0.003, and a simulation counts in days: five of them for each second here.',
  duration: 76,
  parameters: {},
  build(_: object, { integrator = rungeKutta4 }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [attractors()], integrator });
    // A second of the picture is five days, so velocities are five times as large and GM is 25 times as large.
    spawn(world, { position: {}, attractor: 25 * GM, appearance: { size: 12, color: rgba(1, 0.8, 0.35) } });
    const velocity = { y: (5 * 1000 * speed) / SPEED };
    const earth = spawn(world, { position: { x: distance }, velocity, mass: 1, collider: 5 });
    return { world, dt: 1 / 120, earth };
  },
  picture: ({ world, earth }) => ({
    view: { minX: -165, maxX: 165, minY: -165, maxY: 165 },
    trails: [{ body: earth, length: 1200, interval: 8 }],
    labels: [
      { at: { x: -60, y: 30 }, text: () => `day ${(5 * world.time).toFixed(0)}` },
      { at: { x: -60, y: -40 }, text: () => `${(lengthOf(velocityOf(world, earth)) / 5).toFixed(3)} · 10⁹ m a day` },
    ],
  }),
  plots: [
    {
      title: 'Distance of the Earth',
      x: { label: 't, days', value: ({ world }) => 5 * world.time },
      y: { label: 'r, 10⁹ m' },
      series: [{ label: 'distance', value: ({ world, earth }) => lengthOf(positionOf(world, earth)) }],
    },
  ],
  checks: [
    ...[
      { label: 'Constant of gravity', unit: '', exact: 0.00297604446, value: G },
      { label: 'Mass of the Sun', unit: 'Earths', exact: 332981.787, value: SUN },
      { label: 'G times the mass of the Sun', unit: '', exact: 990.968599, value: GM },
      { label: 'Unit of velocity', unit: 'm/s', exact: 11574.074074, value: SPEED },
    ].map(({ label, unit, exact, value }) => ({
      label,
      unit,
      exact,
      // The reference has nine digits.
      tolerance: { relative: 3e-9 },
      at: { time: 0 },
      measure: () => value,
    })),
    {
      label: 'Year, Kepler’s third law; short of 365.26 d, as 29.78 km/s is rounded',
      unit: 'd',
      exact: 364.897,
      tolerance: { relative: 1e-5 },
      at: { event: ({ world, earth }) => positionOf(world, earth).y, count: 1 },
      measure: ({ world }) => 5 * world.time,
    },
  ],
  tryThis: ['Watch the label: the Earth moves by 2.57 of these units a day.'],
});
