// Edges or triangles of a network in the world's memory, for kernels: the first corners of all faces, the second ones and
// so on, then which lives they are.

import { assertBody } from '../ecs/entity-ref.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { allocate } from '../memory/arena.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { partsOf } from './strips.ts';

export interface Faces {
  readonly at: number;
  readonly count: number;
  /** Where the parts of a list of triangles stand: strips.ts. */
  readonly parts: number;
}

/**
 * Puts them there once for each world.
 * @throws PhysicsError E_TYPE, E_RANGE (not whole faces); and when asked for a world: E_STALE, E_CAPACITY
 */
export function facesOf(ids: ArrayLike<number>, corners: 2 | 3, field: string): (world: PhysicsWorld) => Faces {
  if (typeof ids?.length !== 'number') throw new PhysicsError('E_TYPE', `${field} must be an array of ids.`, { field });
  if (ids.length % corners !== 0) {
    throw new PhysicsError('E_RANGE', `${field} must hold ${corners} ids a face, got ${ids.length}.`, { field });
  }
  const places = new WeakMap<PhysicsWorld, Faces>();
  return (world) => {
    let faces = places.get(world);
    if (faces === undefined) {
      faces = place(world, ids, corners, field);
      places.set(world, faces);
    }
    return faces;
  };
}

/** Room behind the faces for the forces on some of them: kernels/soft-bodies/faces.ts. */
const FORCES = 16 + 3 * 128 * 8;

function place(world: PhysicsWorld, ids: ArrayLike<number>, corners: number, field: string): Faces {
  const { arena, generations } = world.internal;
  for (let i = 0; i < ids.length; i++) assertBody(world, ids[i]);
  const count = ids.length / corners;
  const list = corners === 3 ? partsOf(ids, world.rows) : [];
  const at = allocate(arena, 8 * ids.length + FORCES, field);
  const parts = allocate(arena, 4 * list.length, field);
  new Uint32Array(arena.memory.buffer, parts, list.length).set(list);
  const words = new Uint32Array(arena.memory.buffer, at, 2 * ids.length);
  for (let i = 0; i < ids.length; i++) {
    const word = count * (i % corners) + Math.floor(i / corners);
    words[word] = ids[i];
    words[word + ids.length] = generations[ids[i]];
  }
  return { at, count, parts };
}
