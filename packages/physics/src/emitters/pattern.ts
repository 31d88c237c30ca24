// The shape of a burst: velocities that its particles get in turn.

import { MAX_SPEED } from '../components/velocity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkVector, type VectorInput } from '../errors/validate.ts';
import { allocate } from '../memory/arena.ts';
import { markImmutable, namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A list of velocities in a world's memory, such as a ring or a sphere of sparks. */
export interface BurstPattern {
  readonly world: PhysicsWorld;
  /** The number of velocities. */
  readonly count: number;
}

const VELOCITY_BYTES = 24;

/**
 * Stores a list of velocities, m/s, for bursts. A burst whose count is a multiple of the list's length uses each
 * velocity equally often, so its momentum is exactly a multiple of the list's sum. The memory is released with the
 * world.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_DESTROYED
 */
export function createPattern(world: PhysicsWorld, velocities: readonly VectorInput[]): BurstPattern {
  assertUsable(world);
  if (!Array.isArray(velocities) || velocities.length === 0) {
    throw new PhysicsError('E_RANGE', 'velocities must be an array of at least one vector, m/s.', {
      field: 'velocities',
      value: velocities,
    });
  }
  const bounds = { min: -MAX_SPEED, max: MAX_SPEED };
  const numbers = velocities.flatMap((velocity, i) => {
    const { x, y, z } = checkVector(velocity, `velocities[${i}]`, bounds);
    if (world.dimensions === 2 && z !== 0) {
      throw new PhysicsError('E_RANGE', `velocities[${i}].z is ${z} m/s, but must be 0 in a 2D world.`, {
        field: 'velocities',
        value: z,
      });
    }
    return [x, y, z];
  });
  const count = velocities.length;
  const at = allocate(world.internal.arena, count * VELOCITY_BYTES, `a pattern of ${count}`);
  new Float64Array(world.memory.buffer, at, 3 * count).set(numbers);
  const pattern = markImmutable(Object.freeze({ world, count }));
  patternsOf(world).set(pattern, at);
  return pattern;
}

/**
 * The patterns of a world, and the address of the first velocity of each: x, y and z as f64, m/s. It is here and not in the
 * pattern, which is frozen, because a decoded snapshot has another. Restoring a snapshot removes patterns created since,
 * whose memory is reused.
 */
const patternsOf = namedResource('burst patterns', () => new Map<BurstPattern, number>());

/**
 * Returns the address of the velocities.
 * @throws PhysicsError E_RANGE for a pattern of another world, E_STALE for a pattern that a restored snapshot removed
 */
export function addressOf(world: PhysicsWorld, pattern: BurstPattern): number {
  const at = patternsOf(world).get(pattern);
  if (at !== undefined) return at;
  if (pattern?.world !== world) {
    throw new PhysicsError('E_RANGE', 'pattern must be made by createPattern for the world of the emitter.', {
      field: 'pattern',
    });
  }
  throw new PhysicsError('E_STALE', 'this pattern is not one of the world, or was made after the snapshot restored.', {
    field: 'pattern',
    hint: 'Make it again with createPattern after restore.',
  });
}
