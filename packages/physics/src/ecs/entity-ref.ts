import { bitOf } from '../components/all.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { isLeaving } from './bitecs-adapter.ts';
import { assertUsable } from './guards.ts';

declare const reference: unique symbol;

/**
 * A body's name that is never given to another: entity ids are reused, references are not. It names one life of a
 * body, from gaining Position to losing it. A plain number, safe to store and send.
 */
export type EntityRef = number & { readonly [reference]: true };

/** Ids fit 24 bits, because no world of more rows fits 4 GiB; so a safe integer has 29 bits for the life. */
const ID_SPAN = 2 ** 24;

/** Highest capacity a world can have. */
export const MAX_CAPACITY = ID_SPAN - 1;

/** Lives per row before numbers repeat: a body made and removed a thousand times a second on one row for six days. */
const LIVES = 2 ** 29;

/**
 * The reference of a living body.
 * @throws PhysicsError E_STALE when there is no body with this id, E_DESTROYED
 */
export function entityRef(world: PhysicsWorld, eid: number): EntityRef {
  assertBody(world, eid);
  return (lifeOf(world, eid) * ID_SPAN + eid) as EntityRef;
}

function lifeOf(world: PhysicsWorld, eid: number): number {
  return world.internal.generations[eid] % LIVES;
}

/**
 * Returns whether the body of a reference is in the world and not about to leave it: a body that was despawned in this
 * step counts as gone.
 * @throws PhysicsError E_DESTROYED
 */
export function isAlive(world: PhysicsWorld, ref: EntityRef): boolean {
  assertUsable(world);
  if (!Number.isSafeInteger(ref)) return false;
  const eid = ref % ID_SPAN;
  if (!hasBody(world, eid) || lifeOf(world, eid) !== Math.floor(ref / ID_SPAN)) return false;
  return !isLeaving(world, eid);
}

/**
 * The entity id a reference names.
 * @throws PhysicsError E_STALE when that body is gone, even if its id is in use again; E_DESTROYED
 */
export function resolve(world: PhysicsWorld, ref: EntityRef): number {
  if (isAlive(world, ref)) return ref % ID_SPAN;
  throw new PhysicsError('E_STALE', `the body that reference ${String(ref)} names is gone.`, {
    entity: typeof ref === 'number' ? ref % ID_SPAN : undefined,
    value: ref,
    hint: 'Ask `isAlive(world, ref)` before using a reference that may have outlived its body.',
  });
}

/** Whether `eid` is a body now. @throws PhysicsError E_DESTROYED */
export function isBody(world: PhysicsWorld, eid: number): boolean {
  assertUsable(world);
  return hasBody(world, eid);
}

function hasBody(world: PhysicsWorld, eid: number): boolean {
  return isRow(world, eid) && (world.internal.members[eid] & bitOf('Position')) !== 0;
}

function isRow(world: PhysicsWorld, eid: number): boolean {
  return Number.isInteger(eid) && eid > 0 && eid <= world.capacity;
}

/** Whether `eid` has any component of ours, be it a body, a wall or a spring. */
export function isInhabited(world: PhysicsWorld, eid: number): boolean {
  return isRow(world, eid) && world.internal.members[eid] !== 0;
}

/** @throws PhysicsError E_STALE when `eid` is no body, E_DESTROYED */
export function assertBody(world: PhysicsWorld, eid: number): void {
  if (!isBody(world, eid)) throw staleError(eid, `there is no body ${String(eid)} in this world.`);
}

export function staleError(eid: number, problem: string): PhysicsError {
  const entity = typeof eid === 'number' ? eid : undefined;
  return new PhysicsError('E_STALE', problem, { entity, field: 'entity', value: eid });
}
