import { bitOf } from '../components/all';
import { PhysicsError } from '../faults/physics-error';
import type { PhysicsWorld } from '../world';

declare const reference: unique symbol;

/**
 * A body's name that is never given to another: entity ids are reused, references are not. It names one life of a
 * body, from gaining Position to losing it. A plain number, safe to store and send.
 */
export type EntityRef = number & { readonly [reference]: true };

const GENERATION = 2 ** 32;

/**
 * The reference of a living body.
 * @throws PhysicsError E_STALE when there is no body with this id
 */
export function entityRef(world: PhysicsWorld, eid: number): EntityRef {
  assertBody(world, eid);
  return ((world.internal.generations[eid] as number) * GENERATION + eid) as EntityRef;
}

/** Whether the body a reference names is still there. */
export function isAlive(world: PhysicsWorld, ref: EntityRef): boolean {
  const eid = ref % GENERATION;
  return isBody(world, eid) && world.internal.generations[eid] === Math.floor(ref / GENERATION);
}

/**
 * The entity id a reference names.
 * @throws PhysicsError E_STALE when that body is gone, even if its id is in use again
 */
export function resolve(world: PhysicsWorld, ref: EntityRef): number {
  if (!isAlive(world, ref)) {
    throw new PhysicsError('E_STALE', `the body that reference ${ref} names is gone.`, {
      entity: ref % GENERATION,
      value: ref,
      hint: 'Ask `isAlive(world, ref)` before using a reference that may have outlived its body.',
    });
  }
  return ref % GENERATION;
}

/** Whether `eid` is a body now. */
export function isBody(world: PhysicsWorld, eid: number): boolean {
  return Number.isInteger(eid) && eid > 0 && eid <= world.capacity && hasPosition(world, eid);
}

function hasPosition(world: PhysicsWorld, eid: number): boolean {
  return ((world.internal.members[eid] as number) & bitOf('Position')) !== 0;
}

/** @throws PhysicsError E_STALE when `eid` is no body */
export function assertBody(world: PhysicsWorld, eid: number): void {
  if (!isBody(world, eid)) {
    throw new PhysicsError('E_STALE', `there is no body ${eid} in this world.`, { entity: eid, value: eid });
  }
}
