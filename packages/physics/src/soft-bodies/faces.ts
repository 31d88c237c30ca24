// Edges or triangles of a network in the world's memory, for kernels: the first corners of all faces, the second ones and
// so on, then which lives they are.

import { assertBody, isBody } from '../ecs/entity-ref.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';
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
  // A resource, so that a snapshot knows whether they were there: their memory is given back when it is restored.
  return resource((world) => place(world, ids, corners, field));
}

/** Room behind the faces for the forces on some of them: kernels/soft-bodies/faces.ts. */
const FORCES = 16 + 3 * 128 * 8;

function place(world: PhysicsWorld, ids: ArrayLike<number>, corners: number, field: string): Faces {
  const { arena, generations } = world.internal;
  for (let i = 0; i < ids.length; i++) if (!wasBody(world, ids[i])) assertBody(world, ids[i]);
  const count = ids.length / corners;
  const list = corners === 3 ? partsOf(ids, world.rows) : [];
  const at = allocate(arena, 8 * ids.length + FORCES, field);
  const parts = allocate(arena, 4 * list.length, field);
  new Uint32Array(arena.memory.buffer, parts, list.length).set(list);
  const words = new Uint32Array(arena.memory.buffer, at, 2 * ids.length);
  for (let i = 0; i < ids.length; i++) {
    const word = count * (i % corners) + Math.floor(i / corners);
    words[word] = ids[i];
    // A node that is gone already is one that was lost: no generation is this high.
    words[word + ids.length] = isBody(world, ids[i]) ? generations[ids[i]] : 0xffffffff;
  }
  return { at, count, parts };
}

/** Whether some body had this id, be it gone now. */
function wasBody({ capacity, internal }: PhysicsWorld, eid: number): boolean {
  return Number.isInteger(eid) && eid > 0 && eid <= capacity && internal.generations[eid] > 0;
}
