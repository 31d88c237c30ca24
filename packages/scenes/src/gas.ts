// An elastic gas of discs or balls in a box, without other forces. Energy is conserved; only walls change the momentum.
import { boxWalls, createPhysicsWorld, particleContacts, pow, spawnMany } from '@principia/physics';
import type { BoxedRun } from './boxed-run.ts';
import { countOf, defineScene } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** Elastic discs or balls in a box that bounce off each other. */
export const gas = defineScene({
  name: 'gas',
  description: 'elastic discs or balls in a box that bounce off each other',
  precision: 'f32',
  parameters: {
    count: countOf('bodies', 100_000, 4_000_000),
    fraction: { about: 'part of the box that bodies fill', unit: '', initial: 0.4, min: 0.001, max: 0.5 },
    radius: { about: 'largest radius of a body', unit: 'm', initial: 0.5, min: 0.01, max: 100 },
    speed: { about: 'largest initial speed along an axis', unit: 'm/s', initial: 5, min: 0, max: 1000 },
    restitution: { about: 'restitution', unit: '', initial: 1, min: 0, max: 1 },
  },
  build({ dimensions, precision, seed, progress, parameters }) {
    const { count, fraction, radius, speed, restitution } = parameters;
    const across = Math.ceil(pow(count, 1 / dimensions));
    const volume = dimensions === 2 ? Math.PI * radius * radius : (4 / 3) * Math.PI * radius * radius * radius;
    const side = across * pow(volume / fraction, 1 / dimensions);
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count,
      preset: particleContacts,
      walls: [boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: side, y: side, z: side }, restitution })],
    });
    const uniform = seededUniforms(seed, count);
    const push = () => uniform(-speed, speed);
    const places = shuffled(count, uniform(0, 1));
    const axis = (stride: number) =>
      places.map((place) => ((Math.floor(place / stride) % across) + 0.5) * (side / across));
    spawnMany(
      world,
      count,
      {
        position: { x: axis(1), y: axis(across), ...(dimensions === 3 ? { z: axis(across * across) } : {}) },
        velocity: { x: push(), y: push(), ...(dimensions === 3 ? { z: push() } : {}) },
        mass: uniform(0.5, 1.5),
        collider: { radius: uniform(0.8 * radius, radius), restitution },
      },
      progress,
    );
    const far = { x: side, y: side, z: dimensions === 3 ? side : 0 };
    const run: BoxedRun = { world, dt: 1 / 60, far, gravity: 0, restitution, friction: 0 };
    return restitution < 1 ? { ...run, losesEnergy: 'the collisions are not elastic' } : run;
  },
});

/** A random permutation of the numbers below `count`, so that neighbours in the gas are not neighbours in memory. */
function shuffled(count: number, uniforms: Float64Array): Float64Array {
  const order = Float64Array.from({ length: count }, (_, i) => i);
  for (let i = count - 1; i > 0; i--) {
    const j = Math.floor(uniforms[i] * (i + 1));
    const kept = order[i];
    order[i] = order[j];
    order[j] = kept;
  }
  return order;
}
