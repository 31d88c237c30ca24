// Creates many bodies at once, past bitECS's functions for one component of one entity; a test compares the result with
// that of adding component by component.
import { addEntity } from 'bitecs';
import { warnAboutColor } from '#warnings';
import type { ComponentName } from '../components/all.ts';
import { componentGiver, joinQueries, notifyObservers } from '../ecs/bitecs/add-many.ts';
import { highestId } from '../ecs/bitecs/entity-index.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { capacityError, ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertOutsideStep, assertUsable } from '../ecs/guards.ts';
import { belongsTo } from '../ecs/id-lists.ts';
import { cleanRow, openRows } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkWhole, isRecord, mustBe } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type Column, type ComponentValues, checkMany, type ManyInput } from './many.ts';
import { resolveShapes, withShapes } from './shapes-of-many.ts';

/** Called during creation with the number of bodies created so far. */
export type Progress = (created: number, count: number) => void;

const CHUNK = 65536;

/**
 * Creates `count` entities with the same components, and a shape for all or for each: user observers of additions are called when every body is complete
 * (onSet observers are not called), and if one throws, all entities are removed.
 * @returns their ids, ascending if the world never lost a body
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN (all values are checked first), E_CAPACITY, E_REENTRANT
 *   (during a step), E_DESTROYED
 */
export function spawnMany(world: PhysicsWorld, count: number, values: ManyInput, progress?: Progress): Uint32Array {
  assertUsable(world);
  checkWhole(count, 'count', 0, 0xffffffff);
  if (progress !== undefined) checkFunction(progress, 'progress');
  assertOutsideStep(world, 'spawnMany', 'Use spawn, or call it after the step.');
  ensureCapacity(world, count);
  if (!isRecord(values)) throw mustBe('an object', values, 'spawnMany');
  const { body, shapes } = resolveShapes(world, values, count);
  const checked = checkMany(world, body, count);
  warnAboutColorOf(world, checked);
  const ids = new Uint32Array(count);
  // The shapes that are stored now are in no column yet, and are kept nevertheless.
  world.internal.spawning++;
  try {
    const components = shapes === undefined ? checked : withShapes(world, checked, shapes);
    const names = components.map(({ name }) => name);
    createEntities(world, names, ids, progress);
    writeColumns(world, components, ids);
    const changed = joinQueries(world, names, ids);
    openRows(world, names, ids);
    notifyObservers(changed, ids);
  } catch (error) {
    undoSpawn(world, ids);
    throw error;
  } finally {
    world.internal.spawning--;
  }
  return belongsTo(world, ids);
}

function warnAboutColorOf(world: PhysicsWorld, components: readonly ComponentValues[]): void {
  const fields = components.find(({ name }) => name === 'Appearance')?.fields ?? [];
  for (const [field, color] of fields) if (field === 'color') warnAboutColor(world, color);
}

function createEntities(
  world: PhysicsWorld,
  names: readonly ComponentName[],
  ids: Uint32Array,
  progress: Progress | undefined,
): void {
  const count = ids.length;
  const giveComponents = componentGiver(world, names);
  const used = highestId(world);
  for (let i = 0; i < count; i++) {
    const eid = addEntity(world);
    giveComponents(eid);
    ids[i] = eid;
    if (eid > world.capacity) throw capacityError(world, count);
    if (eid <= used) cleanRow(world, eid);
    const created = i + 1;
    if (progress !== undefined && (created % CHUNK === 0 || created === count)) {
      reportProgress(world, progress, created, count);
    }
  }
}

/** Calls the progress function. Meanwhile the world is busy: a step, restore or snapshot would see half of the entities. */
function reportProgress(world: PhysicsWorld, progress: Progress, created: number, count: number): void {
  const { state, internal } = world;
  world.state = 'preparing';
  try {
    progress(created, count);
  } finally {
    world.state = state;
  }
  if (!internal.ending) return;
  internal.ending = false;
  throw new PhysicsError('E_REENTRANT', 'destroyWorld was called by the progress function of spawnMany.', {
    hint: 'Call it after spawnMany.',
  });
}

/** Undoes a creation that an exception interrupted. */
export function undoSpawn(world: PhysicsWorld, ids: Uint32Array): void {
  if (world.state === 'destroyed') return;
  for (const eid of ids) {
    try {
      removeEntityCompletely(world, eid);
    } catch {
      // Only the first exception is reported; a further one of an observer of removals is dropped.
    }
  }
}

type Columns = Record<ComponentName, Record<string, Float64Array>>;

function writeColumns(world: PhysicsWorld, components: readonly ComponentValues[], ids: Uint32Array): void {
  for (const { name, fields } of components) {
    for (const { [name]: columns } of [world.components, world.previous] as Partial<Columns>[]) {
      if (columns !== undefined) for (const [field, values] of fields) writeColumn(columns[field], values, ids);
    }
  }
}

function writeColumn(column: Float64Array, values: Column, ids: Uint32Array): void {
  if (typeof values === 'number') for (let i = 0; i < ids.length; i++) column[ids[i]] = values;
  else for (let i = 0; i < ids.length; i++) column[ids[i]] = values[i];
}
