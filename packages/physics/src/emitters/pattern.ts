// The shape of a burst: velocities its particles are given one after another.

import { MAX_SPEED } from '../components/velocity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkVector, type VectorInput } from '../errors/validate.ts';
import { allocate } from '../memory/arena.ts';
import { markImmutable, resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Velocities in a world's memory: what a ring or a ball of sparks is made from. */
export interface BurstPattern {
  readonly world: PhysicsWorld;
  /** How many velocities there are. */
  readonly count: number;
  /** Address of the first: x, y and z as f64, m/s. Not for users. */
  readonly at: number;
}

const BYTES = 24;

/**
 * Keeps a list of velocities, m/s, for bursts. A burst of as many particles, or a multiple of it, gives each velocity
 * to equally many: its momentum is the sum of the list, exactly. The memory is given back with the world.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_DESTROYED
 */
export function createPattern(world: PhysicsWorld, velocities: readonly VectorInput[]): BurstPattern {
  assertUsable(world);
  if (!Array.isArray(velocities) || velocities.length === 0) {
    throw new PhysicsError('E_RANGE', 'a pattern must be a list of at least one velocity.', { field: 'velocities' });
  }
  const bounds = { min: -MAX_SPEED, max: MAX_SPEED };
  const numbers = velocities.flatMap((velocity, i) => {
    const { x, y, z } = checkVector(velocity, `velocities[${i}]`, bounds);
    if (world.dimensions === 2 && z !== 0) {
      throw new PhysicsError('E_RANGE', `velocities[${i}].z must be 0 in the plane.`, {
        field: 'velocities',
        value: z,
      });
    }
    return [x, y, z];
  });
  const count = velocities.length;
  const at = allocate(world.internal.arena, count * BYTES, `a pattern of ${count}`);
  new Float64Array(world.memory.buffer, at, 3 * count).set(numbers);
  const pattern = markImmutable(Object.freeze({ world, count, at }));
  patternsOf(world).add(pattern);
  return pattern;
}

/** The patterns of a world. A snapshot brings back those that there were: the memory of later ones is used again. */
const patternsOf = resource(() => new Set<BurstPattern>());

/** @throws PhysicsError E_RANGE for the pattern of another world, E_STALE for one that a restored snapshot did not know */
export function checkPattern(world: PhysicsWorld, pattern: BurstPattern): void {
  if (patternsOf(world).has(pattern)) return;
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
