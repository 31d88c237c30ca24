// A crystal of molecules that attract each other at a distance and repel each other when near, by the force between neighbours
// that a user writes (docs/adding-a-force.md): the usual benchmark of molecular dynamics, in its usual units.
import { createPhysicsWorld, pow, spawnMany, velocityVerlet } from '@principia/physics';
import { betweenAtoms } from './atoms.ts';
import { countOf, defineScene } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** Distance of neighbours at rest, diameters: a little less than the 2^(1/6) of two alone. */
const SPACING = 1.1;

/** Places of a cell of neighbours that touch: two in a layer, and two in the next of a crystal in space. */
const PLANE = [
  [0, 0, 0],
  [0.5, Math.sqrt(3) / 2, 0],
];
const SPACE = [
  [0, 0, 0],
  [Math.SQRT1_2, Math.SQRT1_2, 0],
  [Math.SQRT1_2, 0, Math.SQRT1_2],
  [0, Math.SQRT1_2, Math.SQRT1_2],
];

/** A crystal of molecules with the Lennard-Jones force between neighbours, in their own units. */
export const molecules = defineScene({
  name: 'molecules',
  description: 'a crystal of molecules with the Lennard-Jones force between neighbours, in their own units',
  parameters: {
    count: countOf('molecules', 10_000, 1_000_000, 2),
    speed: { about: 'largest speed along an axis at the start', unit: '', initial: 1, min: 0, max: 5 },
  },
  build({ dimensions, precision, seed, progress, parameters: { count, speed } }) {
    const cell = dimensions === 2 ? PLANE : SPACE;
    const sides = dimensions === 2 ? [1, Math.sqrt(3)] : [Math.SQRT2, Math.SQRT2, Math.SQRT2];
    const across = Math.ceil(pow(count / cell.length, 1 / dimensions));
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count,
      integrator: velocityVerlet,
      forces: [betweenAtoms()],
    });
    const strides = [1, across, across * across];
    const uniform = seededUniforms(seed, count);
    const velocity = () => uniform(-speed, speed);
    const axis = (which: 0 | 1 | 2) =>
      Float64Array.from({ length: count }, (_, i) => {
        const place = Math.floor(i / cell.length);
        const cells = Math.floor(place / strides[which]) % across;
        return SPACING * (sides[which] * cells + cell[i % cell.length][which]);
      });
    const isSpace = dimensions === 3;
    spawnMany(
      world,
      count,
      {
        position: { x: axis(0), y: axis(1), ...(isSpace ? { z: axis(2) } : {}) },
        velocity: { x: velocity(), y: velocity(), ...(isSpace ? { z: velocity() } : {}) },
        mass: 1,
      },
      progress,
    );
    return { world, dt: 0.005 };
  },
});
