import {
  boxWalls,
  createPhysicsWorld,
  restrictForce,
  rgba,
  spawn,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

/** Gravitational parameters, km³/s², and mean radii, km. */
const BODIES = [
  { name: 'Moon', GM: 4902.8, R: 1737.4 },
  { name: 'Mars', GM: 42828.4, R: 3389.5 },
  { name: 'Earth', GM: 398600.4, R: 6371 },
  { name: 'Jupiter', GM: 1.26713e8, R: 69911 },
];
const gravities = BODIES.map(({ GM, R }) => (1000 * GM) / (R * R));
const COLOR = [rgba(0.8, 0.8, 0.85), rgba(1, 0.48, 0.45), rgba(0.42, 0.72, 1), rgba(1, 0.7, 0.28)];
const RADIUS = 0.4;

interface Dropped {
  readonly world: { readonly time: number };
  height(i: number): number;
  climb(i: number): number;
}

export default defineExample({
  id: 'ch06-celestial-gravity',
  title: 'The same fall on four worlds',
  chapter: 6,
  tags: ['gravity', 'planets'],
  about:
    'The same ball is dropped from the same height on the Moon, on Mars, on the Earth and on Jupiter. What counts is GM/R²: the mass of the world, and how near you are to its centre. On Jupiter the ball is down in less than a second; on the Moon you could sing a line of a song.',
  duration: 8,
  parameters: {
    height: { label: 'Height', unit: 'm', initial: 10, min: 2, max: 12 },
    restitution: { label: 'Speed kept in a bounce', initial: 0.6, min: 0, max: 0.95 },
  },
  build({ height, restitution }: ValuesOf<'height' | 'restitution'>, { integrator = velocityVerlet }: BuildOptions) {
    // Gravity of its own for each ball: a force over the whole column in which it falls.
    const world = createPhysicsWorld({ capacity: 8, walls: [boxWalls({ min: { y: 0 } })], integrator });
    const balls = COLOR.map((appearance, i) =>
      spawn(world, {
        position: { x: 4 * i, y: height + RADIUS },
        velocity: {},
        mass: 1,
        collider: { radius: RADIUS, restitution },
        appearance,
      }),
    );
    for (const [i, g] of gravities.entries()) {
      world.forces.push(
        restrictForce(uniformGravity({ y: -g }), { region: { min: { x: 4 * i - 2 }, max: { x: 4 * i + 2 } } }),
      );
    }
    const heightOf = (i: number) => positionOf(world, balls[i]).y - RADIUS;
    return { world, dt: 1 / 240, balls, height: heightOf, climb: (i: number) => velocityOf(world, balls[i]).y };
  },
  picture: ({ balls }, { height }) => ({
    view: { minX: -4, maxX: 17, minY: -1.6, maxY: 13.5 },
    fills: BODIES.map((_, i) => ({
      shape: { minX: 4 * i - 1.6, maxX: 4 * i + 1.6, minY: -20, maxY: 0 },
      color: [0x8f95a5, 0xb4503f, 0x3f7f4f, 0xb08a5a][i],
    })),
    lines: [{ from: { x: -2, y: height + RADIUS }, to: { x: 14, y: height + RADIUS }, color: COLORS.ground, width: 1 }],
    trails: balls.map((body) => ({ body, length: 120 })),
    labels: BODIES.map(({ name }, i) => ({
      at: { x: 4 * i - 1.4, y: -1.3 },
      text: `${name} ${gravities[i].toFixed(2)}`,
    })),
  }),
  plots: (plot) => [
    plot(
      'Height',
      'height, m',
      ...BODIES.map(({ name }, i) => ({ label: name, value: ({ height }: Dropped) => height(i) })),
    ),
  ],
  checks: [
    ...[1.624, 3.728, 25.93].map((exact, i) => {
      const at = [0, 1, 3][i];
      return {
        label: `Gravity of ${BODIES[at].name}, GM/R²`,
        unit: 'm/s²',
        exact,
        tolerance: { absolute: i === 2 ? 5e-3 : 5e-4 },
        at: { time: 0.5 },
        // From the fall: 2 (h₀ − h)/t².
        measure: ({ world, height }: Dropped) => (2 * (10 - height(at))) / (world.time * world.time),
      };
    }),
    ...[0, 1, 3].map((at) => ({
      label: `Fall time on ${BODIES[at].name}, in units of √(2h/g)`,
      exact: 1,
      // A step of 1/240 s in the shortest of these times.
      tolerance: { absolute: 5e-3 },
      at: { event: ({ climb }: Dropped) => climb(at) },
      measure: ({ world }: Dropped) => world.time / Math.sqrt(20 / gravities[at]),
    })),
  ],
  tryThis: [
    'Compare Jupiter with Mars: gravity is seven times as strong, and the fall takes not a seventh, but 1/√7 of the time.',
    'Change the height: the order in which the balls arrive stays the same.',
  ],
});
