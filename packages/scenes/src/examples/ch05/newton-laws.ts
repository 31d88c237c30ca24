import { centreOfMass, createPhysicsWorld, momentum, rgba, spawn, springs, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, speedOf, velocityOf } from '../support/read.ts';

const LENGTH = 2;
const FREE_SPEED = 0.7;

export default defineExample({
  id: 'ch05-newton-laws',
  title: 'Newton’s three laws',
  chapter: 5,
  tags: ['forces', 'momentum', 'spring'],
  about:
    'Nothing acts on the violet puck: it keeps its velocity. The other two are joined by a spring. Each is accelerated by the force over its mass, so the light one swings more. The two forces are equal and opposite at any moment: whatever the two do, the dot between them, their centre of mass, moves on evenly.',
  duration: 20,
  parameters: {
    mass: { label: 'Mass of the light puck', unit: 'kg', initial: 2, min: 1, max: 7 },
    stiffness: { label: 'Stiffness of the spring', unit: 'N/m', initial: 30, min: 0, max: 60 },
  },
  presets: [
    { label: 'Equal masses', values: { mass: 7 } },
    { label: 'No spring', values: { stiffness: 0 } },
  ],
  build({ mass, stiffness }: ValuesOf<'mass' | 'stiffness'>, { integrator = velocityVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 8, forces: [springs()], integrator });
    const a = spawn(world, { position: { x: -7 }, velocity: { x: 0.4, y: 2 }, mass, collider: 0.35 });
    const orange = rgba(1, 0.7, 0.28);
    const b = spawn(world, {
      position: { x: -4 },
      velocity: { x: 0.8, y: -0.8 },
      mass: 7,
      collider: 0.6,
      appearance: orange,
    });
    spawn(world, { spring: { a, b, stiffness, length: LENGTH } });
    const violet = rgba(0.72, 0.61, 1);
    const free = spawn(world, {
      position: { x: -7, y: 3 },
      velocity: { x: FREE_SPEED },
      mass: 0.001,
      collider: 0.3,
      appearance: violet,
    });
    const start = { momentum: momentum(world), centre: centreOfMass(world) };
    /** Force of the spring on the light puck. */
    const force = () => {
      const [p, q] = [positionOf(world, a), positionOf(world, b)];
      const d = distanceBetween(p, q);
      const pull = (stiffness * (d - LENGTH)) / d;
      return { x: pull * (q.x - p.x), y: pull * (q.y - p.y) };
    };
    return { world, dt: 1 / 120, a, b, free, start, force };
  },
  picture: ({ world, a, b, free, force }) => ({
    view: { minX: -8.5, maxX: 9, minY: -5.5, maxY: 5 },
    springs: { coils: 9 },
    trails: [a, b, free].map((body) => ({ body, length: 900 })),
    arrows: [
      { label: 'F', from: () => positionOf(world, a), vector: force, scale: 0.05, color: COLORS.red },
      {
        label: '−F',
        from: () => positionOf(world, b),
        vector: () => ({ x: -force().x, y: -force().y }),
        scale: 0.05,
        color: COLORS.red,
      },
      velocityArrow(world, free, 1),
    ],
    dots: [{ at: () => centreOfMass(world), color: COLORS.white }],
  }),
  plots: (plot) => [
    plot(
      'Momentum to the right',
      'p, kg m/s',
      { label: 'all', value: ({ world }) => momentum(world).x },
      { label: 'light', value: ({ world, a }) => world.components.Mass.value[a] * velocityOf(world, a).x },
      { label: 'heavy', value: ({ world, b }) => 7 * velocityOf(world, b).x },
    ),
  ],
  checks: ({ at, largest }) => [
    at(20, 'Speed of the free puck after 20 s', { exact: FREE_SPEED, unit: 'm/s', absolute: 0 }, ({ world, free }) =>
      speedOf(world, free),
    ),
    largest(
      20,
      'Largest change of the momentum in 20 s',
      { exact: 0, unit: 'kg m/s', absolute: 1e-12 },
      ({ world, start }) => distanceBetween(momentum(world), start.momentum),
    ),
    at(
      10,
      'Distance of the centre of mass in 10 s, Σp t/Σm',
      {
        exact: ({ mass }) => (10 * Math.sqrt(quadrance(0.4 * mass + 5.6 + 0.0007, 2 * mass - 5.6))) / (mass + 7.001),
        unit: 'm',
        relative: 1e-9,
      },
      ({ world, start }) => distanceBetween(centreOfMass(world), start.centre),
    ),
  ],
  tryThis: [
    'Take equal masses: both pucks now swing equally far to both sides of the dot.',
    'Set the stiffness to 0: without a force all three move on straight lines.',
  ],
});

function quadrance(x: number, y: number): number {
  return x * x + y * y;
}
