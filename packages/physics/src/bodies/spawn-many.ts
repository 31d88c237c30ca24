// Bodies by the million. bitECS spends 0.8 µs and 200 bytes on an entity alone and calls three observers for three
// components, which doubles that; here a body costs one `addEntity` and, for all its components together, one write of
// its membership mask and one small set. That reaches into bitECS's own tables (public by its `$internal` symbol, and its version is
// pinned); a test holds the result against the component-by-component path.
import { addEntity, type ComponentData, type ComponentRef, type Query, type WorldContext } from 'bitecs';
import { bitOf, type ComponentName } from '../components/all';
import { PhysicsError } from '../faults/physics-error';
import { checkFunction, checkWhole } from '../faults/validate';
import { contextOf, queryOf, removeWholly } from '../store/bitecs';
import { ComponentSet } from '../store/component-set';
import { capacityError, makeRoom } from '../store/entities';
import { assertUsable } from '../store/guards';
import { countIncomplete } from '../store/incomplete';
import { cleanRow } from '../store/rows';
import type { PhysicsWorld } from '../world';
import { checkMany, type Filling, type Many, type ManyInput } from './many';

/** Called as bodies are made, with how many are. */
export type Progress = (made: number, count: number) => void;

const CHUNK = 65536;

/**
 * Makes `count` entities with the same components, all at once: observers of yours are told of additions when every
 * body is complete (onSet observers are not told), and if one throws, all are taken back.
 * @returns their ids, ascending when the world never lost a body
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN (all values are checked first), E_CAPACITY,
 *   E_REENTRANT (during a step), E_DESTROYED
 */
export function spawnMany(world: PhysicsWorld, count: number, values: ManyInput, progress?: Progress): Uint32Array {
  assertUsable(world);
  checkWhole(count, 'count', 0, 0xffffffff);
  if (progress !== undefined) checkFunction(progress, 'progress');
  if (world.state === 'stepping') {
    throw new PhysicsError('E_REENTRANT', 'spawnMany cannot run inside a step.', { hint: 'Use spawn, or wait.' });
  }
  makeRoom(world, count);
  const fillings = checkMany(world, values, count);
  const ids = new Uint32Array(count);
  try {
    makeEntities(world, fillings, ids, progress);
    fillColumns(world, fillings, ids);
    const changed = joinQueries(world, fillings, ids);
    finish(world, fillings, ids);
    tell(changed, ids);
  } catch (error) {
    takeBack(world, ids);
    throw error;
  }
  return ids;
}

function componentData(world: PhysicsWorld, fillings: readonly Filling[]): ComponentData[] {
  const { componentMap } = contextOf(world);
  return fillings.map(({ name }) => componentMap.get(world.components[name]) as ComponentData);
}

function bitsOf(fillings: readonly Filling[]): number {
  return fillings.reduce((bits, { name }) => bits | bitOf(name), 0);
}

function makeEntities(
  world: PhysicsWorld,
  fillings: readonly Filling[],
  ids: Uint32Array,
  progress: Progress | undefined,
): void {
  const count = ids.length;
  const context = contextOf(world);
  const bits = bitsOf(fillings);
  const data = componentData(world, fillings);
  const flags = data.reduce((all, { bitflag }) => all | bitflag, 0);
  const masks = context.entityMasks[data[0]?.generationId ?? 0];
  const used = world.lastId;
  for (let i = 0; i < count; i++) {
    const eid = addEntity(world);
    ids[i] = eid;
    if (eid > world.capacity) throw capacityError(world, count);
    if (eid <= used) cleanRow(world, eid);
    masks[eid] = (masks[eid] ?? 0) | flags;
    context.entityComponents.set(eid, new ComponentSet(world, bits) as unknown as Set<ComponentRef>);
    if (progress !== undefined && (i + 1) % CHUNK === 0 && i + 1 < count) tellProgress(world, progress, i + 1, count);
  }
  if (progress !== undefined) tellProgress(world, progress, count, count);
}

function tellProgress(world: PhysicsWorld, progress: Progress, made: number, count: number): void {
  progress(made, count);
  assertUsable(world);
}

/** A query that the new entities joined, or left again because `Not` no longer holds. */
interface Changed {
  readonly query: Query;
  readonly joined: boolean;
}

/**
 * Adds the entities to every query they match, ours by component and the user's; and takes them out of those that
 * `addEntity` put them in because they had no component yet. All as bitECS does it, `toRemove` included: an id that was
 * freed since the last query is still listed there.
 */
function joinQueries(world: PhysicsWorld, fillings: readonly Filling[], ids: Uint32Array): Changed[] {
  const context = contextOf(world);
  const changed: Changed[] = [];
  if (ids.length === 0) return changed;
  const unobserved = new Set<Query>();
  for (const { name } of fillings) {
    if ((world.internal.observed & bitOf(name)) === 0) unobserved.add(queryOf(world, name));
  }
  const affected = new Set(componentData(world, fillings).flatMap(({ queries }) => [...queries]));
  for (const query of affected) {
    const joined = matches(context, query, ids[0]);
    if (joined) join(query, ids);
    else if (!leave(context, query, ids)) continue;
    if (!unobserved.has(query)) changed.push({ query, joined });
  }
  return changed;
}

/** bitECS's own test of an entity against a query; all new entities have the same components. */
function matches(context: WorldContext, query: Query, eid: number): boolean {
  const has = (generation: string) => context.entityMasks[Number(generation)]?.[eid] ?? 0;
  const anyOf = Object.entries(query.orMasks);
  return (
    Object.entries(query.masks).every(([g, mask]) => (has(g) & mask) === mask) &&
    Object.entries(query.notMasks).every(([g, mask]) => (has(g) & mask) === 0) &&
    (anyOf.length === 0 || anyOf.some(([g, mask]) => (has(g) & mask) !== 0))
  );
}

function join(query: Query, ids: Uint32Array): void {
  const pending = query.toRemove.dense.length > 0;
  for (let i = 0; i < ids.length; i++) {
    if (pending) query.toRemove.remove(ids[i]);
    query.add(ids[i]);
  }
}

/** Whether any was in. */
function leave(context: WorldContext, query: Query, ids: Uint32Array): boolean {
  let any = false;
  for (let i = 0; i < ids.length; i++) {
    if (!query.has(ids[i]) || query.toRemove.has(ids[i])) continue;
    query.toRemove.add(ids[i]);
    any = true;
  }
  if (any) context.dirtyQueries.add(query);
  return any;
}

/** Tells users' observers. One of them may remove bodies the others were to be told of. */
function tell(changed: readonly Changed[], ids: Uint32Array): void {
  for (const { query, joined } of changed) {
    for (let i = 0; i < ids.length; i++) {
      const isIn = query.has(ids[i]) && !query.toRemove.has(ids[i]);
      if (joined && isIn) query.addObservable.notify(ids[i]);
      else if (!joined && !isIn) query.removeObservable.notify(ids[i]);
    }
  }
}

/** Undoes a creation that an exception of the user's code cut short. */
function takeBack(world: PhysicsWorld, ids: Uint32Array): void {
  if (world.state === 'destroyed') return;
  for (let i = 0; i < ids.length && ids[i] !== 0; i++) {
    try {
      removeWholly(world, ids[i]);
    } catch {
      // Whoever threw at the creation is reported; that an observer of removals throws as well adds nothing.
    }
  }
}

type Columns = Record<ComponentName, Record<string, Float64Array>>;

function fillColumns(world: PhysicsWorld, fillings: readonly Filling[], ids: Uint32Array): void {
  const run = isRun(ids);
  for (const { name, fields } of fillings) {
    for (const { [name]: columns } of [world.components, world.previous] as Partial<Columns>[]) {
      if (columns !== undefined) for (const [field, many] of fields) writeColumn(columns[field], many, ids, run);
    }
  }
}

function writeColumn(column: Float64Array, many: Many, ids: Uint32Array, run: boolean): void {
  const count = ids.length;
  if (run && typeof many === 'number') column.fill(many, ids[0], ids[0] + count);
  else if (run) column.set(many as ArrayLike<number>, ids[0]);
  else if (typeof many === 'number') for (let i = 0; i < count; i++) column[ids[i]] = many;
  else for (let i = 0; i < count; i++) column[ids[i]] = many[i];
}

/** Whether the ids are consecutive; recycled ones come in any order. */
function isRun(ids: Uint32Array): boolean {
  for (let i = 1; i < ids.length; i++) if (ids[i] !== ids[i - 1] + 1) return false;
  return ids.length > 0;
}

function finish(world: PhysicsWorld, fillings: readonly Filling[], ids: Uint32Array): void {
  const { internal, versions } = world;
  const bits = bitsOf(fillings);
  for (const { name } of fillings) internal.counts[name] += ids.length;
  for (let i = 0; i < ids.length; i++) {
    const eid = ids[i];
    internal.members[eid] |= bits;
    if (bits !== 0 && eid > world.lastId) world.lastId = eid;
  }
  countIncomplete(world, 0, bits, ids.length);
  versions.membership++;
  versions.style++;
  versions.pose++;
}
