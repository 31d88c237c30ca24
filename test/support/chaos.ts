/**
 * Chaotic scenes that amplify any difference, to test that two runs are equal to the last bit. Uses no test library.
 */
import {
  attractors,
  bodies,
  boxWalls,
  createPhysicsWorld,
  createRandom,
  linearDrag,
  type PhysicsWorld,
  type Precision,
  particleContacts,
  quadraticDrag,
  spawn,
  springs,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';

const SIDE = 20;

/** Discs or balls on springs that collide in a box with three attractors: errors grow with every contact. */
export function chaoticWorld(dimensions: 2 | 3, precision: Precision, seed = 7, count = 120): PhysicsWorld {
  const world = createPhysicsWorld({
    preset: particleContacts,
    dimensions,
    precision,
    seed,
    capacity: 1000,
    forces: [uniformGravity({ y: -3 }), linearDrag({ x: 0.3 }), quadraticDrag(), attractors(), springs()],
    walls: [boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: SIDE, y: SIDE, z: SIDE }, restitution: 0.9 })],
  });
  const random = createRandom(seed);
  const point = (low: number, high: number) => {
    const [x, y] = [random.uniform(low, high), random.uniform(low, high)];
    return dimensions === 2 ? { x, y } : { x, y, z: random.uniform(low, high) };
  };
  for (let i = 0; i < 3; i++) spawn(world, { position: point(5, 15), attractor: { mu: 40, softening: 0.3 } });
  const ids = Array.from({ length: count }, () =>
    spawn(world, {
      position: point(1, SIDE - 1),
      velocity: point(-6, 6),
      mass: random.uniform(0.5, 2),
      collider: { radius: 0.2, restitution: 0.8, friction: 0.3 },
      linearDrag: random.uniform(0, 0.01),
      quadraticDrag: random.uniform(0, 0.001),
      inertia: 0.02,
      angularVelocity: { z: random.uniform(-5, 5) },
      ...(dimensions === 2 ? { rotation: {} } : { orientation: {} }),
    }),
  );
  for (let i = 1; i < count; i += 2) {
    spawn(world, { spring: { a: ids[i - 1], b: ids[i], stiffness: 30, damping: 0.1, length: 2 } });
  }
  return world;
}

/** Returns the hash after `count` steps of 1/60 s. */
export function hashAfter(world: PhysicsWorld, count: number): string {
  for (let i = 0; i < count; i++) step(world, 1 / 60);
  return stateHash(world);
}

/**
 * Returns a hash of positions and velocities of all bodies, 16 hexadecimal digits. Unlike `stateHash` it is
 * independent of the project's components, so that values can be kept for years.
 */
export function motionHash(world: PhysicsWorld): string {
  const { Position, Velocity, AngularVelocity } = world.components;
  const { ids, count } = bodies(world);
  let [high, low] = [0x811c9dc5, 0x01000193];
  for (const { x, y, z } of [Position, Velocity, AngularVelocity]) {
    for (const column of [x, y, z]) {
      const values = Float64Array.from(ids.subarray(0, count), (eid) => column[eid] + 0);
      for (const word of new Uint32Array(values.buffer)) {
        high = Math.imul(high ^ word, 0x01000193) ^ (low >>> 15);
        low = Math.imul(low ^ word, 0x85ebca6b) ^ (high >>> 13);
      }
    }
  }
  return [high, low].map((word) => (word >>> 0).toString(16).padStart(8, '0')).join('');
}

/** The final hash of each chaotic world, which a browser must reproduce. */
export function chaosHashes(count = 1500): Record<string, string> {
  const hashes: Record<string, string> = {};
  for (const dimensions of [2, 3] as const) {
    for (const precision of ['f32', 'f64'] as const) {
      const world = chaoticWorld(dimensions, precision);
      for (let i = 0; i < count; i++) step(world, 1 / 60);
      hashes[`${dimensions}D ${precision}`] = motionHash(world);
    }
  }
  return hashes;
}
