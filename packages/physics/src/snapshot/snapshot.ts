// Saves a world and restores it bitwise: for rewinding, for look-ahead, for networks with rollback.
//
// All numbers are in the world's one memory, so a snapshot is a copy of it. It also holds the entities of bitECS, the
// lists of forces and systems, and state of features outside the memory.

import { assertIdle } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { Content, type Snapshot } from './content.ts';

/**
 * Saves the world: bodies and their components, particle pools of emitters, random streams, contacts, state of
 * integrators, forces, systems, faults, and the objects passed to `keepState`. It does not save event handlers and
 * bitECS components that are not in the world's memory. Cost: one copy of the memory in use, and some microseconds.
 * @param spare a snapshot of this world that is no longer needed: it is overwritten and returned. Nothing is allocated
 *   then unless the world has grown
 * @throws PhysicsError E_REENTRANT inside a step; E_TYPE, also for an instance of a class inside kept objects; E_DESTROYED
 */
export function snapshot(world: PhysicsWorld, spare?: Snapshot): Snapshot {
  assertIdle(world, 'snapshot');
  const content = spare === undefined ? new Content(world) : contentOf(spare, 'snapshot', world);
  content.take();
  return content;
}

/**
 * Restores the world: the next steps are bitwise equal to those after the snapshot. Bodies created since are removed,
 * bodies removed since are created again, and observers are called; a recreated body has the components of the package
 * and those that the world was created with. References, emitters and contact lists obtained since are invalid. Queries
 * may list bodies in another order; `bodies(world)` does not.
 * @throws PhysicsError E_TYPE for a snapshot of another world, E_REENTRANT, E_DESTROYED: nothing is changed
 * @throws AggregateError of exceptions of observers, after everything is restored
 */
export function restore(world: PhysicsWorld, snapshot: Snapshot): void {
  assertIdle(world, 'restore');
  const content = contentOf(snapshot, 'restore', world);
  content.assertWritable();
  const thrown = content.putBack();
  world.versions.restored++;
  if (thrown.length > 0) throw new AggregateError(thrown, `restore: observers threw ${thrown.length} exception(s).`);
}

/** @throws PhysicsError E_TYPE for a value that is no snapshot, or an incomplete one, or of another world than `world` */
export function contentOf(snapshot: Snapshot, caller: string, world?: PhysicsWorld): Content {
  const found = Content.isContent(snapshot) ? snapshot : undefined;
  if (found?.isWhole === true && (world === undefined || found.world === world)) return found;
  const problem =
    found === undefined ? 'the argument is not a snapshot' : 'the snapshot is of another world, or incomplete';
  throw new PhysicsError('E_TYPE', `${caller}: ${problem}.`, {
    field: 'snapshot',
    hint: 'Pass a value that `snapshot(world)` returned for the same world, or `decodeSnapshot(world, …)`.',
  });
}
