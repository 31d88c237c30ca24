import { centreOfMass, createPhysicsWorld, gaussRadau, momentum, mutualGravity, rgba, spawn } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const G = 1e5;
type Values = ValuesOf<'m2' | 'v1' | 'v2'>;

/** Period of the relative orbit of bodies of 1 and m₂, which start 200 apart at right angles to their line. */
function period({ m2, v1, v2 }: Values): number {
  const mu = G * (1 + m2);
  const a = 1 / (2 / 200 - ((v1 - v2) * (v1 - v2)) / mu);
  return 2 * Math.PI * a * Math.sqrt(a / mu);
}

/** Change of the time between two passes of the farthest point, where the motion is slow. */
const orbit = { label: 'Period', unit: 's', tolerance: { relative: 1e-3 } };

export default defineExample({
  id: 'ch06-two-masses',
  title: 'Two bodies pull at each other',
  chapter: 6,
  tags: ['gravity', 'orbit', 'momentum'],
  about:
    'The small planet is pulled by the large one, and pulls back with the same force. So both circle around their common centre of mass, the white dot, the heavy one in small circles. The centre itself moves on evenly, because nothing pulls from outside. This wobble is how astronomers find planets that nobody can see.',
  duration: 42,
  conservesEnergy: true,
  // At least 5 px/s are between the two, or they would fall into each other.
  parameters: {
    m2: { label: 'Mass of the red body', unit: 'kg', initial: 60, min: 1, max: 100 },
    v1: { label: 'Velocity of the blue body', unit: 'px/s', initial: 150, min: 10, max: 200 },
    v2: { label: 'Velocity of the red body', unit: 'px/s', initial: 0, min: -10, max: 5 },
  },
  presets: [
    { label: 'At rest together', values: { v2: -2.5 } },
    { label: 'Equal masses', values: { m2: 1, v1: 10, v2: -10 } },
  ],
  build({ m2, v1, v2 }: Values, { integrator = gaussRadau() }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [mutualGravity({ G })], integrator });
    const blue = spawn(world, { position: { x: 150, y: 200 }, velocity: { y: v1 }, mass: 1, collider: 10 });
    const size = m2 === 1 ? 10 : 40;
    const red = spawn(world, {
      position: { x: 350, y: 200 },
      velocity: { y: v2 },
      mass: m2,
      appearance: { size, color: rgba(1, 0.48, 0.45) },
    });
    const distance = () => distanceBetween(positionOf(world, blue), positionOf(world, red));
    /** Distance times its rate of change: negative while they approach. */
    const parting = () => {
      const [p, q] = [positionOf(world, blue), positionOf(world, red)];
      const [v, w] = [velocityOf(world, blue), velocityOf(world, red)];
      return (p.x - q.x) * (v.x - w.x) + (p.y - q.y) * (v.y - w.y);
    };
    return { world, dt: 1 / 120, blue, red, distance, parting };
  },
  picture: ({ world, blue, red }) => ({
    yDown: true,
    view: { minX: 50, maxX: 700, minY: 0, maxY: 400 },
    trails: [blue, red].map((body) => ({ body, length: 900 })),
    lines: [{ from: () => positionOf(world, blue), to: () => positionOf(world, red), color: COLORS.ground, width: 1 }],
    arrows: [velocityArrow(world, blue, 0.3), velocityArrow(world, red, 3)],
    dots: [
      { at: { x: 150, y: 200 }, radius: 3, color: COLORS.grey },
      { at: { x: 350, y: 200 }, radius: 3, color: COLORS.grey },
      { at: () => centreOfMass(world), radius: 4, color: COLORS.white },
    ],
  }),
  plots: (plot) => [
    plot('Distance of the two', 'r, px', { label: 'distance', value: ({ distance }) => distance() }),
    plot(
      'Velocity across the line of the start',
      'v, px/s',
      { label: 'blue', value: ({ world, blue }) => velocityOf(world, blue).y },
      { label: 'red', value: ({ world, red }) => velocityOf(world, red).y },
    ),
  ],
  checks: ({ at, largest, smallest }) => [
    {
      ...orbit,
      exact: period,
      at: { event: ({ parting }) => -parting(), from: 1, to: 2 },
    },
    largest(11, 'Largest distance', { exact: 200, unit: 'px', relative: 1e-5 }, ({ distance }) => distance()),
    at(
      10,
      'Momentum after 10 s, m₁ v₁ + m₂ v₂',
      { exact: 150, unit: 'kg px/s', relative: 1e-12 },
      ({ world }) => momentum(world).y,
    ),
    at(
      10,
      'Velocity of the centre of mass',
      { exact: ({ m2, v1, v2 }) => (v1 + m2 * v2) / (1 + m2), unit: 'px/s', absolute: 1e-9 },
      ({ world }) => (centreOfMass(world).y - 200) / world.time,
    ),
    {
      ...orbit,
      label: 'Period at rest together',
      exact: 5.227,
      at: { event: ({ parting }) => -parting(), from: 1, to: 2 },
      preset: 'At rest together',
    },
    at(
      10,
      'Momentum of both at rest together',
      { exact: 0, unit: 'kg px/s', absolute: 1e-10, preset: 'At rest together' },
      ({ world }) => momentum(world).y,
    ),
    smallest(
      20,
      'Smallest distance of equal masses, a (1 − e) = 125 · 0.4',
      { exact: 50, unit: 'px', relative: 1e-3, preset: 'Equal masses' },
      ({ distance }) => distance(),
    ),
    {
      ...orbit,
      label: 'Period of equal masses',
      exact: 6.25 * Math.PI,
      at: { event: ({ parting }) => -parting(), from: 1, to: 2 },
      preset: 'Equal masses',
    },
  ],
  tryThis: [
    'Choose “At rest together”: the push of the small one and that of the large one cancel, and the white dot stays in its place.',
    'Choose equal masses: both move along ellipses of the same size, always opposite each other.',
  ],
});
