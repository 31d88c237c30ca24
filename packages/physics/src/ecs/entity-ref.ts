import { entityExists } from 'bitecs';
import { warnAboutDeadRef } from '#warnings';
import { bitOf } from '../components/membership.ts';
import { describe, PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { isLeaving } from './bitecs/remove-entity.ts';
import { assertUsable } from './guards.ts';
import { isRowUsed } from './rows.ts';

declare const reference: unique symbol;

/**
 * A reference to a body that is never reused: entity ids are reused, references are not. It identifies one generation
 * of an id, from gaining Position to losing it, and other worlds of the same program refuse it. It is a plain number, safe
 * to store and send: programs that create their worlds in the same order have the same references.
 */
export type EntityRef = number & { readonly [reference]: true };

/**
 * Ids fit 24 bits, because a world with more rows exceeds 4 GiB; a safe integer has 29 bits left for the generation.
 */
const ID_SPAN = 2 ** 24;

/** Maximum capacity of a world. */
export const MAX_CAPACITY = ID_SPAN - 1;

/** A generation that no row reaches: kernels take who has it as removed. */
export const NO_GENERATION = 0xffffffff;

/** Generations per row before references repeat: one row reused a thousand times a second for six days. */
const MAX_GENERATIONS = 2 ** 29;

/**
 * 2^29 divided by the golden ratio, and odd: its first n multiples are nearly as far apart, modulo 2^29, as n numbers can be
 * (Knuth, The Art of Computer Programming 3, section 6.4, theorem S).
 */
const GOLDEN = 331_804_471;

/** From 1 on, because the first references of a world whose generations begin at 0 would be its ids. */
let worldsCreated = 1;

/**
 * Returns where the generations in references of the next world begin. Two of a thousand worlds begin more than 200 000
 * generations apart, so that a reference of one names nothing in another.
 */
export function nextFirstGeneration(): number {
  return Math.imul(worldsCreated++, GOLDEN) & (MAX_GENERATIONS - 1);
}

/**
 * Returns the reference of a living body.
 * @throws PhysicsError E_STALE if there is no body with this id, E_DESTROYED
 */
export function entityRef(world: PhysicsWorld, eid: number): EntityRef {
  assertBody(world, eid);
  return (generationOf(world, eid) * ID_SPAN + eid) as EntityRef;
}

function generationOf(world: PhysicsWorld, eid: number): number {
  const { generations, firstGeneration } = world.internal;
  return (firstGeneration + generations[eid]) % MAX_GENERATIONS;
}

/**
 * Returns whether the body of a reference exists. A body that was despawned in this step does not count as existing.
 * @throws PhysicsError E_DESTROYED
 */
export function isAlive(world: PhysicsWorld, ref: EntityRef): boolean {
  assertUsable(world);
  if (!Number.isSafeInteger(ref)) return false;
  const eid = ref % ID_SPAN;
  const isThere = isPresent(world, eid) && generationOf(world, eid) === Math.floor(ref / ID_SPAN);
  if (!isThere) warnAboutDeadRef(world, ref);
  return isThere && !isLeaving(world, eid);
}

/**
 * Returns the entity id of a reference.
 * @throws PhysicsError E_STALE if the body was removed, even if its id is in use again, or if the reference is one of
 *   another world; E_DESTROYED
 */
export function resolve(world: PhysicsWorld, ref: EntityRef): number {
  if (isAlive(world, ref)) return ref % ID_SPAN;
  throw new PhysicsError(
    'E_STALE',
    `${describe(ref)} refers to no body of this world: it was removed, or lives in another.`,
    {
      entity: typeof ref === 'number' ? ref % ID_SPAN : undefined,
      value: ref,
      hint: 'Call `isAlive(world, ref)` before using a reference whose body may have been removed.',
    },
  );
}

/** Returns whether `eid` is a body, and was not despawned in this step. @throws PhysicsError E_DESTROYED */
export function isBody(world: PhysicsWorld, eid: number): boolean {
  assertUsable(world);
  return isPresent(world, eid) && !isLeaving(world, eid);
}

/** Whether a row has a body that bitECS has not removed in this step. */
function isPresent(world: PhysicsWorld, eid: number): boolean {
  return hasBody(world, eid) && !world.internal.edits.departed.has(eid);
}

/** Whether a row has a body: one that was despawned moves on until the step ends. */
export function hasBody(world: PhysicsWorld, eid: number): boolean {
  return isRow(world, eid) && (world.internal.members[eid] & bitOf('Position')) !== 0;
}

function isRow(world: PhysicsWorld, eid: number): boolean {
  return Number.isInteger(eid) && eid > 0 && eid <= world.capacity;
}

/** Returns whether `eid` has any component of the engine: it may be a body, a wall or a spring. */
export function hasAnyComponent(world: PhysicsWorld, eid: number): boolean {
  return isRow(world, eid) && isRowUsed(world, eid);
}

/**
 * @throws PhysicsError E_STALE if `eid` is not a body, E_DESTROYED
 */
export function assertBody(world: PhysicsWorld, eid: number): void {
  assertUsable(world);
  // During a step the rows do not know yet that an entity was removed through bitECS.
  const isKnown = isPresent(world, eid);
  const exists = isRow(world, eid) && entityExists(world, eid);
  if (isKnown && exists) return;
  if (world.state === 'stepping' && exists) {
    const hint = 'Pass its values to `spawn`, and do the rest after the step.';
    throw staleError(eid, `body ${eid} was spawned during this step and can be used only after it.`, hint);
  }
  if (exists && isRowUsed(world, eid)) {
    throw staleError(eid, `entity ${eid} is no body, because it has no Position.`, 'Spawn it with `position: {}`.');
  }
  throw noBody(eid);
}

/** A number above all ids is most often a reference. */
export function noBody(eid: number): PhysicsError {
  const hint = typeof eid === 'number' && eid > MAX_CAPACITY ? 'Of a reference pass resolve(world, ref).' : undefined;
  return staleError(eid, `there is no body ${describe(eid)} in this world.`, hint);
}

export function staleError(eid: number, problem: string, hint?: string): PhysicsError {
  const entity = typeof eid === 'number' ? eid : undefined;
  return new PhysicsError('E_STALE', problem, { entity, field: 'entity', value: eid, ...(hint && { hint }) });
}
