import { addComponent, addEntity, entityExists, hasComponent, set } from 'bitecs';
import { warnAboutColor } from '#warnings';
import { type Shape, storeShape } from '../collision/shapes/2d/shape.ts';
import { COMPONENT_NAMES, type ComponentName, keyOf } from '../components/all.ts';
import { generationOf } from '../ecs/bitecs/context.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { hasAnyComponent, noBody, staleError } from '../ecs/entity-ref.ts';
import { assertUsable } from '../ecs/guards.ts';
import { checkValues, completeValues, initialValues } from '../ecs/values.ts';
import type { PhysicsError } from '../errors/physics-error.ts';
import { isRecord, mustBe, unknownName } from '../errors/validate.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';
import type { BodyInput } from './body-input.ts';
import { type ResolvedInput, resolveShape } from './collider-shape.ts';
import { removeWithParts } from './parts.ts';

const NAME_OF_KEY = new Map<string, ComponentName>(COMPONENT_NAMES.map((name) => [keyOf(name), name]));

/** Returns the component for a key of `spawn`. @throws PhysicsError E_UNKNOWN */
export function componentOfKey(key: string, caller: string): ComponentName {
  const name = NAME_OF_KEY.get(key);
  if (name === undefined) throw unknownName(caller, 'option', key, [...NAME_OF_KEY.keys()]);
  return name;
}

/**
 * Creates one entity with the given components. A component given as `{}` gets its initial values; an omitted or
 * undefined component is absent, except that a body with mass gets a zero velocity. All values are validated first.
 * During a step the body is created at the end of the step, and what is written to its columns until then is lost. An
 * exception of a user's observer removes the entity and
 * propagates.
 * @returns the entity id
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_DESTROYED
 */
export function spawn(world: PhysicsWorld, body: BodyInput): number {
  assertUsable(world);
  const { body: resolved, shape } = resolveInput(world, body);
  const checked = checkBody(world, resolved);
  ensureCapacity(world, 1);
  if (shape !== undefined) setIndex(world, checked, shape);
  const { internal } = world;
  // That of an outer call, one of whose observers calls this one.
  const { checked: outer } = internal;
  let eid = 0;
  internal.spawning++;
  try {
    eid = addEntity(world);
    for (const [name, values] of checked) {
      internal.checked = values;
      addComponent(world, eid, set(world.components[name], values));
    }
  } catch (error) {
    // bitECS fails where an observer has removed the entity.
    if (error instanceof TypeError && !isThere(world, eid)) throw removedError(eid);
    if (eid > 0) removeEntityCompletely(world, eid);
    throw error;
  } finally {
    internal.checked = outer;
    internal.spawning--;
  }
  return eid;
}

function isThere(world: PhysicsWorld, eid: number): boolean {
  return world.state !== 'destroyed' && entityExists(world, eid);
}

function removedError(eid: number): PhysicsError {
  return staleError(eid, `entity ${eid} was removed by an observer while it was spawned.`, 'Remove it after spawn.');
}

function resolveInput(world: PhysicsWorld, body: BodyInput): ResolvedInput<BodyInput> {
  if (!isRecord(body)) throw mustBe('an object', body, 'spawn');
  return resolveShape(world, body);
}

/** Shapes enter the pool only when all values are known to be valid, so that an error leaves the world unchanged. */
function setIndex(world: PhysicsWorld, checked: [ComponentName, FieldValues][], shape: Shape): void {
  const index = storeShape(world, shape);
  for (const [name, values] of checked) if (name === 'Collider') values.shape = index;
}

function checkBody(world: PhysicsWorld, body: BodyInput): [ComponentName, FieldValues][] {
  const checked: [ComponentName, FieldValues][] = [];
  for (const [key, data] of Object.entries(body)) {
    if (data === undefined) continue;
    const name = componentOfKey(key, 'spawn');
    const values = checkValues(world, name, data);
    if (name === 'Appearance') warnAboutColor(world, values.color);
    checked.push([name, completeValues(world, name, values, () => initialValues(name))]);
  }
  if (lacksVelocity(checked.map(([name]) => name))) checked.push(['Velocity', initialValues('Velocity')]);
  return checked;
}

/**
 * A body with mass is meant to move: without Velocity forces would have no effect. Only the two spawn functions add
 * components that were not given; components attached by hand stay as they are.
 */
export function lacksVelocity(names: readonly ComponentName[]): boolean {
  return names.includes('Position') && names.includes('Mass') && !names.includes('Velocity');
}

/**
 * Removes a body with its parts (or a wall, or a spring) and its entity. During a step removal takes effect at the end of the step;
 * until then the body takes part in the step, but `isAlive` is false for it, and removing it again does nothing.
 * A particle of an emitter ends instead as by `endParticle`: its entity stays in the pool, and waits for the next birth.
 * @throws PhysicsError E_STALE if there is no entity with this id, E_DESTROYED; and exceptions of user observers, after
 *   the entity is removed
 */
export function despawn(world: PhysicsWorld, eid: number): void {
  assertUsable(world);
  if (!mayDespawn(world, eid)) throw noBody(eid);
  remove(world, eid);
}

/** Whether `despawn` accepts this id now. */
export function mayDespawn(world: PhysicsWorld, eid: number): boolean {
  if (world.state !== 'stepping') return hasAnyComponent(world, eid);
  // Asks bitECS rather than the rows: bodies created in this step have no rows yet, and others may be removed already.
  return Number.isInteger(eid) && entityExists(world, eid) && hasAny(world, eid);
}

/** Removes what `mayDespawn`, during a step when it ends. The entity of a particle stays in the pool of its emitter. */
export function remove(world: PhysicsWorld, eid: number): void {
  if (world.internal.endIfPooled?.(world, eid)) return;
  if (world.state === 'stepping') despawnLater(world, eid);
  else removeWithParts(world, eid);
}

function despawnLater(world: PhysicsWorld, eid: number): void {
  const { leaving, deferred } = world.internal.edits;
  const generation = generationOf(world, eid);
  if (leaving.get(eid) === generation) return;
  leaving.set(eid, generation as object);
  deferred.push(() => {
    if (generationOf(world, eid) === generation) removeWithParts(world, eid);
  });
}

function hasAny(world: PhysicsWorld, eid: number): boolean {
  return COMPONENT_NAMES.some((name) => hasComponent(world, eid, world.components[name]));
}
