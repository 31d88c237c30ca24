// Creates many bodies at once. bitECS takes 0.8 µs and 200 bytes for an entity alone and calls three observers for
// three components, which doubles that; here a body costs one `addEntity` and, for all its components together, one
// write of its membership masks and one small set. This uses bitECS's internal tables (public by its `$internal` symbol;
// its version is pinned); a test compares the result with that of adding component by component.
import { addEntity, type ComponentRef, type Query, type WorldContext } from 'bitecs';
import { storeShape } from '../collision/shapes/2d/shape.ts';
import type { ComponentName } from '../components/all.ts';
import { bitsOf } from '../components/membership.ts';
import { contextOf, maskChanges, queriesOf, removeEntityCompletely } from '../ecs/bitecs-adapter.ts';
import { ComponentSet } from '../ecs/component-set.ts';
import { capacityError, ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { belongsTo } from '../ecs/id-lists.ts';
import { countPartialEntities } from '../ecs/partial-entities.ts';
import { cleanRow } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkWhole, isRecord, mustBe } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { resolveShape } from './collider-shape.ts';
import { type Column, type ComponentValues, checkMany, type ManyInput, withShape } from './many.ts';

/** Called during creation with the number of bodies created so far. */
export type Progress = (created: number, count: number) => void;

const CHUNK = 65536;

/**
 * Creates `count` entities with the same components: user observers of additions are called when every body is complete
 * (onSet observers are not called), and if one throws, all entities are removed.
 * @returns their ids, ascending if the world never lost a body
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN (all values are checked first), E_CAPACITY, E_REENTRANT
 *   (during a step), E_DESTROYED
 */
export function spawnMany(world: PhysicsWorld, count: number, values: ManyInput, progress?: Progress): Uint32Array {
  assertUsable(world);
  checkWhole(count, 'count', 0, 0xffffffff);
  if (progress !== undefined) checkFunction(progress, 'progress');
  if (world.state === 'stepping') {
    throw new PhysicsError('E_REENTRANT', 'spawnMany cannot run inside a step.', {
      hint: 'Use spawn, or call it after the step.',
    });
  }
  ensureCapacity(world, count);
  if (!isRecord(values)) throw mustBe('an object', values, 'spawnMany');
  const { body, shape } = resolveShape(world, values);
  const checked = checkMany(world, body, count);
  const components = shape === undefined ? checked : withShape(checked, storeShape(world, shape));
  const ids = new Uint32Array(count);
  try {
    createEntities(world, components, ids, progress);
    writeColumns(world, components, ids);
    const changed = joinQueries(world, components, ids);
    finish(world, components, ids);
    notifyObservers(changed, ids);
  } catch (error) {
    undoSpawn(world, ids);
    throw error;
  }
  return belongsTo(world, ids);
}

function createEntities(
  world: PhysicsWorld,
  components: readonly ComponentValues[],
  ids: Uint32Array,
  progress: Progress | undefined,
): void {
  const count = ids.length;
  const context = contextOf(world);
  const names = components.map(({ name }) => name);
  const bits = bitsOf(names);
  const changes = maskChanges(world, names);
  const used = world.lastId;
  for (let i = 0; i < count; i++) {
    const eid = addEntity(world);
    ids[i] = eid;
    if (eid > world.capacity) throw capacityError(world, count);
    if (eid <= used) cleanRow(world, eid);
    for (let m = 0; m < changes.length; m++) changes[m].masks[eid] |= changes[m].bits;
    context.entityComponents.set(eid, new ComponentSet(world, bits) as unknown as Set<ComponentRef>);
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

/** A query that the new entities joined, or left because `Not` no longer holds. */
interface Changed {
  readonly query: Query;
  readonly joined: boolean;
}

/**
 * Adds the entities to every query they match, ours by component and the user's, and removes them from queries that
 * `addEntity` added them to because they had no component yet. All have the same components, so the first represents
 * all.
 * @returns the queries that users may observe
 */
function joinQueries(world: PhysicsWorld, components: readonly ComponentValues[], ids: Uint32Array): Changed[] {
  const context = contextOf(world);
  const affected = new Set(components.flatMap(({ name }) => queriesOf(world, name)));
  const changed: Changed[] = [];
  for (const query of affected) {
    const joined = matches(context, query, ids[0]);
    if (!joined && !isIn(query, ids[0])) continue;
    if (joined) joinQuery(query, ids);
    else leaveQuery(context, query, ids);
    if (!world.internal.unobserved.has(query)) changed.push({ query, joined });
  }
  return changed;
}

/** bitECS's own test of an entity against a query. A mask is absent if it has no bit. */
function matches({ entityMasks }: WorldContext, query: Query, eid: number): boolean {
  const { generations, masks, notMasks, orMasks, orComponents } = query;
  const has = (generation: number) => entityMasks[generation][eid];
  return (
    generations.every((g) => (masks[g] & ~has(g)) === 0 && (notMasks[g] & has(g)) === 0) &&
    (orComponents.length === 0 || generations.some((g) => (orMasks[g] & has(g)) !== 0))
  );
}

/** Returns whether an entity is in a query; the list itself keeps removed entities until bitECS is queried next. */
function isIn(query: Query, eid: number): boolean {
  return query.has(eid) && !query.toRemove.has(eid);
}

function joinQuery(query: Query, ids: Uint32Array): void {
  const pending = query.toRemove.dense.length > 0;
  for (let i = 0; i < ids.length; i++) {
    if (pending) query.toRemove.remove(ids[i]);
    query.add(ids[i]);
  }
}

function leaveQuery({ dirtyQueries }: WorldContext, query: Query, ids: Uint32Array): void {
  for (let i = 0; i < ids.length; i++) if (query.has(ids[i])) query.toRemove.add(ids[i]);
  dirtyQueries.add(query);
}

/** Calls users' observers. One of them may remove bodies that the others were about to receive. */
function notifyObservers(changed: readonly Changed[], ids: Uint32Array): void {
  for (const { query, joined } of changed) {
    const { notify } = joined ? query.addObservable : query.removeObservable;
    for (let i = 0; i < ids.length; i++) if (isIn(query, ids[i]) === joined) notify(ids[i]);
  }
}

/** Undoes a creation that an exception of user code interrupted. */
function undoSpawn(world: PhysicsWorld, ids: Uint32Array): void {
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

function finish(world: PhysicsWorld, components: readonly ComponentValues[], ids: Uint32Array): void {
  const { internal, versions } = world;
  const { first, second } = bitsOf(components.map(({ name }) => name));
  for (const { name } of components) internal.counts[name] += ids.length;
  for (let i = 0; i < ids.length; i++) {
    const eid = ids[i];
    internal.members[eid] |= first;
    internal.moreMembers[eid] |= second;
    if (components.length > 0 && eid > world.lastId) world.internal.lastId = eid;
  }
  countPartialEntities(world, 0, first, ids.length);
  versions.membership++;
  versions.style++;
  versions.pose++;
}
