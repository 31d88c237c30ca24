// Discs or balls of several sizes that fall in a box and fill two fifths of it: many collisions at first, a heap at the
// end.
import { boxWalls, createPhysicsWorld, particleContacts, pow, spawnMany, uniformGravity } from '@principia/physics';
import type { BoxedRun } from './boxed-run.ts';
import { countOf, defineScene } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** Ratio of the smallest to the largest radius. */
const MIN_RADIUS_RATIO = 0.7;
/** Fraction of the box that bodies fill: of its area in 2D, of its volume in 3D. */
const FILL_SHARE = { 2: 0.4, 3: 0.3 } as const;
/** Means of r² and r³ for radii uniform from `MIN_RADIUS_RATIO` to 1. */
const MEAN_SQUARE = (1 - MIN_RADIUS_RATIO * MIN_RADIUS_RATIO * MIN_RADIUS_RATIO) / (3 * (1 - MIN_RADIUS_RATIO));
const MEAN_CUBE =
  (1 - MIN_RADIUS_RATIO * MIN_RADIUS_RATIO * MIN_RADIUS_RATIO * MIN_RADIUS_RATIO) / (4 * (1 - MIN_RADIUS_RATIO));
/** Density of water, kg/m³; in 2D the discs are a metre thick. */
const DENSITY = 1000;
/** Memory for contacts and the broad phase. */
const BYTES_PER_BODY = 600;

/** Discs or balls that fall and collide in a box they fill to two fifths. */
export const circles = defineScene({
  name: 'circles',
  description: 'discs or balls that fall and collide in a box they fill to two fifths',
  precision: 'f32',
  parameters: {
    count: countOf('discs or balls', 10_000, 1_000_000),
    gravity: { about: 'acceleration of free fall', unit: 'm/s²', initial: 9.80665, min: 0, max: 1000 },
    radius: { about: 'largest radius', unit: 'm', initial: 0.1, min: 0.001, max: 1000 },
    restitution: { about: 'restitution of bodies and walls', unit: '', initial: 0.3, min: 0, max: 1 },
    friction: { about: 'friction of bodies and walls', unit: '', initial: 0, min: 0, max: 2 },
    speed: { about: 'largest initial speed along an axis', unit: 'm/s', initial: 2, min: 0, max: 1000 },
  },
  build({ dimensions, precision, seed, progress, parameters }) {
    const { count, gravity, radius, restitution, friction, speed } = parameters;
    const { columns, rows, layers, cell } = lattice(count, dimensions, radius);
    const max = { x: columns * cell, y: rows * cell, ...(dimensions === 3 ? { z: layers * cell } : {}) };
    const min = { x: 0, y: 0, ...(dimensions === 3 ? { z: 0 } : {}) };
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count,
      arenaBytes: 2 ** 22 + BYTES_PER_BODY * count,
      preset: particleContacts,
      forces: [uniformGravity({ y: -gravity })],
      walls: [boxWalls({ min, max, restitution, friction })],
    });
    const uniform = seededUniforms(seed, count);
    const push = () => uniform(-speed, speed);
    const radii = uniform(MIN_RADIUS_RATIO * radius, radius);
    const centre = (place: (i: number) => number) =>
      Float64Array.from({ length: count }, (_, i) => (place(i) + 0.5) * cell);
    const layer = columns * layers;
    const volume = dimensions === 2 ? (r: number) => Math.PI * r * r : (r: number) => (4 / 3) * Math.PI * r * r * r;
    spawnMany(
      world,
      count,
      {
        position: {
          x: centre((i) => i % columns),
          y: centre((i) => Math.floor(i / layer)),
          ...(dimensions === 3 ? { z: centre((i) => Math.floor(i / columns) % layers) } : {}),
        },
        velocity: { x: push(), y: push(), ...(dimensions === 3 ? { z: push() } : {}) },
        mass: radii.map((r) => DENSITY * volume(r)),
        collider: { radius: radii, restitution, friction },
      },
      progress,
    );
    const far = { z: 0, ...max };
    const run: BoxedRun = { world, dt: 1 / 120, far, gravity, restitution, friction };
    return { ...run, losesEnergy: 'collisions are not elastic' };
  },
});

/** A lattice for `count` bodies that do not touch, in a box twice as wide as high or in a cube. */
function lattice(count: number, dimensions: 2 | 3, radius: number) {
  if (dimensions === 2) {
    const cell = radius * Math.max(2, Math.sqrt((Math.PI * MEAN_SQUARE) / FILL_SHARE[2]));
    const columns = Math.ceil(Math.sqrt(2 * count));
    return { columns, rows: Math.ceil(count / columns), layers: 1, cell };
  }
  const cell = radius * Math.max(2, pow(((4 / 3) * Math.PI * MEAN_CUBE) / FILL_SHARE[3], 1 / 3));
  const columns = Math.ceil(pow(count, 1 / 3) - 1e-9);
  return { columns, rows: Math.ceil(count / (columns * columns)), layers: columns, cell };
}
