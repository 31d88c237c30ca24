// Test particles that orbit several fixed attractors and do not interact. Every particle evaluates every attractor in
// each step, which makes this the costliest of local forces.
import {
  attractors as attraction,
  createPhysicsWorld,
  createRandom,
  spawn,
  spawnMany,
  velocityVerlet,
} from '@principia/physics';
import { countOf, defineScene } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** Half the edge of the square or cube of initial positions, m. */
const HALF_EXTENT = 100;
/** Attractors lie within this distance of the origin along each axis, m. */
const CLUSTER = 50;

/** Test particles round several fixed attractors. */
export const attractors = defineScene({
  name: 'attractors',
  description: 'test particles round several fixed attractors',
  precision: 'f32',
  parameters: {
    count: countOf('particles', 100_000, 8_000_000),
    attractors: { about: 'fixed centres', unit: '', initial: 8, min: 1, max: 1000, integer: true },
    mu: { about: 'gravitational parameter of all centres together', unit: 'm³/s²', initial: 16_000, min: 0, max: 1e9 },
    softening: { about: 'softening length of a centre', unit: 'm', initial: 5, min: 0.1, max: 100 },
  },
  build({ dimensions, precision, seed, progress, parameters }) {
    const { count, attractors: centres, mu, softening } = parameters;
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count + centres,
      integrator: velocityVerlet,
      forces: [attraction()],
    });
    const random = createRandom(seed, 1);
    for (let c = 0; c < centres; c++) {
      const place = () => (centres === 1 ? 0 : random.uniform(-CLUSTER, CLUSTER));
      const position = { x: place(), y: place(), ...(dimensions === 3 ? { z: place() } : {}) };
      spawn(world, { position, attractor: { mu: mu / centres, softening } });
    }
    const uniform = seededUniforms(seed, count);
    const position = {
      x: uniform(-HALF_EXTENT, HALF_EXTENT),
      y: uniform(-HALF_EXTENT, HALF_EXTENT),
      ...(dimensions === 3 ? { z: uniform(-HALF_EXTENT, HALF_EXTENT) } : {}),
    };
    const velocity = circularVelocities(position.x, position.y, mu);
    spawnMany(world, count, { position, velocity, mass: 1 }, progress);
    return { world, dt: 1 / 60 };
  },
});

/** Velocities of circular orbits about the origin, as if all attractors were spread over the cluster. */
function circularVelocities(x: Float64Array, y: Float64Array, mu: number) {
  const velocity = { x: new Float64Array(x.length), y: new Float64Array(x.length) };
  for (let i = 0; i < x.length; i++) {
    const square = x[i] * x[i] + y[i] * y[i];
    const spread = square + CLUSTER * CLUSTER;
    const rate = Math.sqrt(mu / (spread * Math.sqrt(spread)));
    velocity.x[i] = -rate * y[i];
    velocity.y[i] = rate * x[i];
  }
  return velocity;
}
