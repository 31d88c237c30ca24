// Bodies by the million. bitECS spends 0.8 µs and 200 bytes on an entity alone and calls three observers for three
// components, which doubles that; here a body costs one `addEntity` and, for all its components together, one write of
// its membership mask and one small set. That reaches into bitECS's own tables (public by its `$internal` symbol, and its version is
// pinned); a test holds the result against the component-by-component path.
import { addEntity, type ComponentRef, type Query, type WorldContext } from 'bitecs';
import { storeShape } from '../collision/shapes/2d/shape.ts';
import { bitOf, type ComponentName } from '../components/all.ts';
import { contextOf, queriesOf, removeWholly } from '../ecs/bitecs-adapter.ts';
import { ComponentSet } from '../ecs/component-set.ts';
import { capacityError, makeRoom } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { countPartialEntities } from '../ecs/partial-entities.ts';
import { cleanRow } from '../ecs/rows.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkWhole, isRecord, mustBe } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { resolveShape } from './collider-shape.ts';
import { type Column, checkMany, type Filling, type ManyInput, withShape } from './many.ts';

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
  if (!isRecord(values)) throw mustBe('an object', values, 'spawnMany');
  const { body, shape } = resolveShape(world, values);
  const checked = checkMany(world, body, count);
  const fillings = shape === undefined ? checked : withShape(checked, storeShape(world, shape));
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
  // Our components are the first that bitECS hears of, so its bits for them are ours.
  const masks = context.entityMasks[0];
  const used = world.lastId;
  for (let i = 0; i < count; i++) {
    const eid = addEntity(world);
    ids[i] = eid;
    if (eid > world.capacity) throw capacityError(world, count);
    if (eid <= used) cleanRow(world, eid);
    masks[eid] |= bits;
    context.entityComponents.set(eid, new ComponentSet(world, bits) as unknown as Set<ComponentRef>);
    const made = i + 1;
    if (progress !== undefined && (made % CHUNK === 0 || made === count)) {
      progress(made, count);
      assertUsable(world);
    }
  }
}

/** A query that the new entities joined, or left again because `Not` no longer holds. */
interface Changed {
  readonly query: Query;
  readonly joined: boolean;
}

/**
 * Adds the entities to every query they match, ours by component and the user's; and takes them out of those that
 * `addEntity` put them in because they had no component yet. All have the same components, so the first stands for all.
 * @returns those that users may be observing
 */
function joinQueries(world: PhysicsWorld, fillings: readonly Filling[], ids: Uint32Array): Changed[] {
  const context = contextOf(world);
  const affected = new Set(fillings.flatMap(({ name }) => queriesOf(world, name)));
  const changed: Changed[] = [];
  for (const query of affected) {
    const joined = matches(context, query, ids[0]);
    if (!joined && !isIn(query, ids[0])) continue;
    if (joined) join(query, ids);
    else leave(context, query, ids);
    if (!world.internal.unobserved.has(query)) changed.push({ query, joined });
  }
  return changed;
}

/** bitECS's own test of an entity against a query. Masks are absent where they have no bit. */
function matches({ entityMasks }: WorldContext, query: Query, eid: number): boolean {
  const { generations, masks, notMasks, orMasks, orComponents } = query;
  const has = (generation: number) => entityMasks[generation][eid];
  return (
    generations.every((g) => (masks[g] & ~has(g)) === 0 && (notMasks[g] & has(g)) === 0) &&
    (orComponents.length === 0 || generations.some((g) => (orMasks[g] & has(g)) !== 0))
  );
}

/** Whether an entity is in a query; the list itself holds those that left until bitECS is next asked. */
function isIn(query: Query, eid: number): boolean {
  return query.has(eid) && !query.toRemove.has(eid);
}

function join(query: Query, ids: Uint32Array): void {
  const pending = query.toRemove.dense.length > 0;
  for (let i = 0; i < ids.length; i++) {
    if (pending) query.toRemove.remove(ids[i]);
    query.add(ids[i]);
  }
}

function leave({ dirtyQueries }: WorldContext, query: Query, ids: Uint32Array): void {
  for (let i = 0; i < ids.length; i++) if (query.has(ids[i])) query.toRemove.add(ids[i]);
  dirtyQueries.add(query);
}

/** Tells users' observers. One of them may remove bodies the others were to be told of. */
function tell(changed: readonly Changed[], ids: Uint32Array): void {
  for (const { query, joined } of changed) {
    const { notify } = joined ? query.addObservable : query.removeObservable;
    for (let i = 0; i < ids.length; i++) if (isIn(query, ids[i]) === joined) notify(ids[i]);
  }
}

/** Undoes a creation that an exception of the user's code cut short. */
function takeBack(world: PhysicsWorld, ids: Uint32Array): void {
  if (world.state === 'destroyed') return;
  for (const eid of ids) {
    try {
      removeWholly(world, eid);
    } catch {
      // Whoever threw at the creation is reported; that an observer of removals throws as well adds nothing.
    }
  }
}

type Columns = Record<ComponentName, Record<string, Float64Array>>;

function fillColumns(world: PhysicsWorld, fillings: readonly Filling[], ids: Uint32Array): void {
  for (const { name, fields } of fillings) {
    for (const { [name]: columns } of [world.components, world.previous] as Partial<Columns>[]) {
      if (columns !== undefined) for (const [field, values] of fields) writeColumn(columns[field], values, ids);
    }
  }
}

function writeColumn(column: Float64Array, values: Column, ids: Uint32Array): void {
  if (typeof values === 'number') for (let i = 0; i < ids.length; i++) column[ids[i]] = values;
  else for (let i = 0; i < ids.length; i++) column[ids[i]] = values[i];
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
  countPartialEntities(world, 0, bits, ids.length);
  versions.membership++;
  versions.style++;
  versions.pose++;
}
