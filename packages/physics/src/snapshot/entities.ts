// Saves the entities of bitECS and restores them through bitECS itself, so that queries and observers are updated.
import { addComponent, type ComponentRef, entityExists, removeComponent } from 'bitecs';
import { COMPONENT_NAMES } from '../components/all.ts';
import { BUILT_IN_BITS, bitInWord, isInFirstWord, type MemberBits } from '../components/membership.ts';
import { componentGiver, joinQueries, notifyObservers } from '../ecs/bitecs/add-many.ts';
import {
  countEntities,
  highestId,
  isSameIndex,
  livingEntities,
  recreateEntity,
  type SavedIndex,
  saveIndex,
  writeIndex,
} from '../ecs/bitecs/entity-index.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { isOpen, isRowUsed, openRows } from '../ecs/rows.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The saved entities, in arrays that later snapshots reuse. */
export interface SavedEntities extends SavedIndex {
  /** Component bits in both words, of the rows that may have some. */
  members: Uint32Array;
  moreMembers: Uint32Array;
  rows: number;
}

export function noEntities(): SavedEntities {
  const none = new Uint32Array(0);
  return { dense: none, length: 0, alive: 0, maxId: 0, members: none, moreMembers: none, rows: 0 };
}

export function saveEntities(world: PhysicsWorld, into: SavedEntities): void {
  saveIndex(world, into, roundUpCapacity);
  const { members, moreMembers } = world.internal;
  const rows = rowsWithComponents(world);
  if (into.members.length < rows) {
    into.members = new Uint32Array(roundUpCapacity(rows));
    into.moreMembers = new Uint32Array(roundUpCapacity(rows));
  }
  for (let row = 0; row < rows; row++) {
    into.members[row] = members[row];
    into.moreMembers[row] = moreMembers[row];
  }
  into.rows = rows;
}

/** `lastId` counts no entity whose components are all the user's own. */
function rowsWithComponents(world: PhysicsWorld): number {
  const { lastId, internal, rows } = world;
  return internal.ownComponents.size === 0 ? lastId + 1 : Math.min(highestId(world) + 1, rows);
}

/** Rounds the capacity up, so that a world that grows slowly does not reallocate each time. */
function roundUpCapacity(count: number): number {
  return count + (count >> 3) + 16;
}

/**
 * Restores bitECS's entities and components. The caller restores the columns with the memory.
 * @returns exceptions of user observers
 */
export function restoreEntities(world: PhysicsWorld, saved: SavedEntities): unknown[] {
  const thrown: unknown[] = [];
  const attempt = (act: () => void) => {
    try {
      act();
    } catch (error) {
      thrown.push(error);
    }
  };
  if (!isSameIndex(world, saved)) {
    const savedIds = new Set(saved.dense.subarray(0, saved.alive));
    removeOthers(world, savedIds, attempt);
    recreateMissing(world, saved, savedIds, attempt);
  }
  changeAllComponents(world, saved, attempt);
  // Observers may have created entities or changed components when they were notified of restored entities.
  for (let round = 0; round < MAX_ROUNDS && !isSameIndex(world, saved); round++) {
    removeOthers(world, new Set(saved.dense.subarray(0, saved.alive)), attempt);
    changeAllComponents(world, saved, attempt);
    if (countEntities(world) === saved.alive) break;
  }
  writeIndex(world, saved);
  return thrown;
}

/** Maximum number of rounds that undo edits by observers, because an observer may repeat its edit in every round. */
const MAX_ROUNDS = 8;

/** Entities that are gone come back with all their components at once, those of equal components together. */
function recreateMissing(world: PhysicsWorld, saved: SavedEntities, ids: ReadonlySet<number>, attempt: Attempt): void {
  const groups = new Map<string, number[]>();
  for (const eid of ids) {
    if (entityExists(world, eid)) continue;
    recreateEntity(world, eid);
    const key = eid < saved.rows ? `${saved.members[eid]} ${saved.moreMembers[eid] & BUILT_IN_BITS}` : '0 0';
    const group = groups.get(key);
    if (group === undefined) groups.set(key, [eid]);
    else group.push(eid);
  }
  groups.delete('0 0');
  for (const group of groups.values()) addSavedComponents(world, saved, Uint32Array.from(group), attempt);
}

function addSavedComponents(world: PhysicsWorld, saved: SavedEntities, group: Uint32Array, attempt: Attempt): void {
  // An observer of an earlier group may have removed an entity of this one, or given it components.
  const ids = group.filter((eid) => entityExists(world, eid) && !isRowUsed(world, eid));
  if (ids.length === 0) return;
  const [first, second] = [saved.members[ids[0]], saved.moreMembers[ids[0]]];
  const names = COMPONENT_NAMES.filter((name) => ((isInFirstWord(name) ? first : second) & bitInWord(name)) !== 0);
  const giveComponents = componentGiver(world, names);
  for (const eid of ids) giveComponents(eid);
  openRows(world, names, ids);
  notifyObservers(joinQueries(world, names, ids), ids, attempt);
}

type Attempt = (act: () => void) => void;

function removeOthers(world: PhysicsWorld, savedIds: ReadonlySet<number>, attempt: Attempt): void {
  for (const eid of livingEntities(world)) if (!savedIds.has(eid)) attempt(() => removeEntityCompletely(world, eid));
}

function changeAllComponents(world: PhysicsWorld, saved: SavedEntities, attempt: Attempt): void {
  const { members, moreMembers } = world.internal;
  const rows = Math.max(saved.rows, rowsWithComponents(world));
  for (let eid = 1; eid < rows; eid++) {
    const isSaved = eid < saved.rows;
    const first = isSaved ? saved.members[eid] : 0;
    const second = isSaved ? saved.moreMembers[eid] : 0;
    if (members[eid] !== first || moreMembers[eid] !== second) changeComponents(world, eid, { first, second }, attempt);
  }
}

/** Handles each change separately, so that an observer that throws does not prevent the others. */
function changeComponents(world: PhysicsWorld, eid: number, saved: MemberBits, attempt: Attempt): void {
  const change = (component: ComponentRef, belonged: boolean, belongs: boolean) => {
    if (belonged !== belongs) attempt(() => (belongs ? addComponent : removeComponent)(world, eid, component));
  };
  for (const name of COMPONENT_NAMES) {
    const belongs = ((isInFirstWord(name) ? saved.first : saved.second) & bitInWord(name)) !== 0;
    change(world.components[name], isOpen(world, eid, name), belongs);
  }
  const { moreMembers, ownComponents } = world.internal;
  for (const { bit, columns } of ownComponents.values()) {
    change(columns, (moreMembers[eid] & bit) !== 0, (saved.second & bit) !== 0);
  }
}
