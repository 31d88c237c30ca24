// Components for many entities at once. bitECS takes 0.8 µs and 200 bytes for an entity alone and calls three observers
// for three components, which doubles that; here an entity costs one `addEntity` and, for all its components together,
// one write of its membership masks and one small set.
import type { ComponentRef, Query, WorldContext } from 'bitecs';
import type { ComponentName } from '../../components/all.ts';
import { bitsOf } from '../../components/membership.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { ComponentSet } from './component-set.ts';
import { contextOf } from './context.ts';
import { queriesOf } from './guard-tables.ts';

/** Bits that bitECS sets in a column of masks, one mask an entity, when an entity gains components. */
interface MaskChange {
  readonly masks: number[];
  readonly bits: number;
}

/** What `addComponent` of all these components writes to bitECS's masks. */
function maskChanges(world: PhysicsWorld, names: readonly ComponentName[]): MaskChange[] {
  const { componentMap, entityMasks } = contextOf(world);
  const bits = new Map<number, number>();
  for (const name of names) {
    const data = componentMap.get(world.components[name]);
    if (data !== undefined) bits.set(data.generationId, (bits.get(data.generationId) ?? 0) | data.bitflag);
  }
  return [...bits].map(([generation, all]) => ({ masks: entityMasks[generation], bits: all }));
}

/** Returns a function that gives a new entity these components; it is in no query of them yet. */
export function componentGiver(world: PhysicsWorld, names: readonly ComponentName[]): (eid: number) => void {
  const { entityComponents } = contextOf(world);
  const bits = bitsOf(names);
  const changes = maskChanges(world, names);
  return (eid) => {
    for (let m = 0; m < changes.length; m++) changes[m].masks[eid] |= changes[m].bits;
    entityComponents.set(eid, new ComponentSet(world, bits) as unknown as Set<ComponentRef>);
  };
}

/** A query that the new entities joined, or left because `Not` no longer holds. */
export interface ChangedQuery {
  readonly query: Query;
  readonly joined: boolean;
}

/**
 * Adds the entities to every query they match, ours by component and the user's, and removes them from queries that
 * `addEntity` added them to because they had no component yet. All have the same components, so the first represents
 * all.
 * @returns the queries that users may observe
 */
export function joinQueries(world: PhysicsWorld, names: readonly ComponentName[], ids: Uint32Array): ChangedQuery[] {
  const context = contextOf(world);
  const affected = new Set(names.flatMap((name) => queriesOf(world, name)));
  const changed: ChangedQuery[] = [];
  for (const query of affected) {
    const joined = matches(context, query, ids[0]);
    if (!joined && !isIn(query, ids[0])) continue;
    if (joined) joinQuery(query, ids);
    else leaveQuery(context, query, ids);
    if (!world.internal.unobserved.has(query)) changed.push({ query, joined });
  }
  return changed;
}

/** Calls users' observers. One of them may remove bodies that the others were about to receive. */
export function notifyObservers(
  changed: readonly ChangedQuery[],
  ids: Uint32Array,
  attempt = (act: () => void): void => act(),
): void {
  for (const { query, joined } of changed) {
    const { notify } = joined ? query.addObservable : query.removeObservable;
    for (let i = 0; i < ids.length; i++) if (isIn(query, ids[i]) === joined) attempt(() => notify(ids[i]));
  }
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
