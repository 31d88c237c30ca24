// Edges or triangles of a soft body, copied to the world's memory for kernels: the first corners of all faces, the
// second corners and so on, then the generations of all corners in the same order.

import { assertBody, hasBody, NO_GENERATION } from '../ecs/entity-ref.ts';
import { assertBelongs } from '../ecs/id-lists.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { type ForceMemory, forceMemory, type TakeBytes } from '../memory/force-memory.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { listStrips } from './strips.ts';
import { quadsPerRow } from './woven.ts';

export interface Faces {
  readonly at: number;
  readonly count: number;
  /** Address of the list of quad strips: strips.ts. */
  readonly sections: number;
  /** Address of the springs along their sides, 0 unless they are looked after: threads.ts. */
  readonly threads: number;
  /** The number of quads per row if they are the triangles of a cloth with springs along rows and columns, else 0. */
  readonly quads: number;
  /** The membership version of the world when `areGone` or `dropTornFaces` last looked at them; -1 before the first time. */
  membership: number;
}

/**
 * Returns the faces in a world's memory, copied on first use, with room for the springs along their sides if `tears`.
 * @throws PhysicsError E_TYPE, E_RANGE (incomplete faces); on first use: E_STALE, E_CAPACITY, and E_TYPE in a world
 *   other than that of the ids
 */
export function facesOf(ids: ArrayLike<number>, corners: 2 | 3, field: string, tears = false): ForceMemory<Faces> {
  if (typeof ids?.length !== 'number')
    throw new PhysicsError('E_TYPE', `${field} must be an array of entity ids.`, { field, value: ids });
  if (ids.length % corners !== 0) {
    throw new PhysicsError(
      'E_RANGE',
      `${field} has ${ids.length} ids, but must have a multiple of ${corners}: the corners of each face.`,
      { field },
    );
  }
  // A resource, so that restoring a snapshot from before its creation also frees its memory.
  return forceMemory((world, take) => copyFaces(world, take, { ids, corners, field, tears }));
}

/** The memory of faces is state: they know their corners by the generations of the first step, and not bodies with the same ids. */
export function stateOfFaces({ key }: ForceMemory<Faces>, corners: 2 | 3, tears = false): NonNullable<Force['memory']> {
  return { key, form: `${corners} corners${tears ? ' and threads' : ''}` };
}

/** Returns whether none of the bodies at the corners is left, after bodies came or went. */
export function areGone(world: PhysicsWorld, faces: Faces, corners: number): boolean {
  if (faces.membership === world.versions.membership) return false;
  faces.membership = world.versions.membership;
  const { at, count } = faces;
  const { buffer } = world.memory;
  const { generations } = world.internal;
  const total = corners * count;
  const words = new Uint32Array(buffer, at, 2 * total);
  for (let i = 0; i < total; i++) if (generations[words[i]] === words[total + i]) return false;
  return total > 0;
}

/** Bytes of scratch memory behind the faces, for the forces of a chunk: kernels/soft-bodies/faces.ts. */
const FORCE_BYTES = 16 + 3 * 128 * 8;

/** Bytes of the springs along the sides of a triangle: three ids, 0 where there is none. */
const THREAD_BYTES = 12;

interface FaceList {
  readonly ids: ArrayLike<number>;
  readonly corners: number;
  readonly field: string;
  readonly tears: boolean;
}

function copyFaces(world: PhysicsWorld, take: TakeBytes, { ids, corners, field, tears }: FaceList): Faces {
  const { arena, generations } = world.internal;
  assertBelongs(world, ids, field);
  for (let i = 0; i < ids.length; i++) if (!wasBody(world, ids[i])) assertBody(world, ids[i]);
  const count = ids.length / corners;
  const list = corners === 3 ? listStrips(ids, world.rows) : [];
  const at = take(8 * ids.length + FORCE_BYTES, field);
  const sections = take(4 * list.length, field);
  const threads = tears ? take(THREAD_BYTES * count, field) : 0;
  new Uint32Array(arena.memory.buffer, sections, list.length).set(list);
  const words = new Uint32Array(arena.memory.buffer, at, 2 * ids.length);
  for (let i = 0; i < ids.length; i++) {
    const word = count * (i % corners) + Math.floor(i / corners);
    words[word] = ids[i];
    // A node that does not exist counts as removed.
    words[word + ids.length] = hasBody(world, ids[i]) ? generations[ids[i]] : NO_GENERATION;
  }
  return { at, count, sections, threads, quads: quadsPerRow(ids), membership: -1 };
}

/** Returns whether an entity ever had this id. */
function wasBody({ capacity, internal }: PhysicsWorld, eid: number): boolean {
  return Number.isInteger(eid) && eid > 0 && eid <= capacity && internal.generations[eid] > 0;
}
