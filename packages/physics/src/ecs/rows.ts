// Rows of the columns: initialised when an entity gains a component, and zeroed when it loses it.
import { removeComponent } from 'bitecs';
import { COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import { BUILT_IN_BITS, bitInWord, bitsOf, isInFirstWord } from '../components/membership.ts';
import { type Columns, copyPose } from '../memory/previous-pose.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';
import { countPartialEntities } from './partial-entities.ts';
import { initialValues } from './values.ts';

/** Returns whether the row of a component is in use. */
export function isOpen(world: PhysicsWorld, eid: number, name: ComponentName): boolean {
  const { members, moreMembers } = world.internal;
  return ((isInFirstWord(name) ? members : moreMembers)[eid] & bitInWord(name)) !== 0;
}

/** Returns whether an entity has any component of the package. */
export function isRowUsed({ internal }: PhysicsWorld, eid: number): boolean {
  return (internal.members[eid] | (internal.moreMembers[eid] & BUILT_IN_BITS)) !== 0;
}

function toggleBit(world: PhysicsWorld, eid: number, name: ComponentName): void {
  const { members, moreMembers } = world.internal;
  const bit = bitInWord(name);
  if (isInFirstWord(name)) {
    countPartialEntities(world, members[eid], members[eid] ^ bit);
    members[eid] ^= bit;
  } else {
    moreMembers[eid] ^= bit;
  }
}

/** Initialises a row with the initial values of the component. */
export function openRow(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (isOpen(world, eid, name)) return;
  const { internal, versions } = world;
  if (!isRowUsed(world, eid)) cleanRow(world, eid);
  toggleBit(world, eid, name);
  internal.counts[name]++;
  if (eid > world.lastId) world.internal.lastId = eid;
  versions.membership++;
  writeRow(world, eid, name, initialValues(name));
}

/** Marks the rows of many new entities as in use. The caller writes all their columns. */
export function openRows(world: PhysicsWorld, names: readonly ComponentName[], ids: Uint32Array): void {
  const { internal, versions } = world;
  const { first, second } = bitsOf(names);
  for (const name of names) internal.counts[name] += ids.length;
  for (let i = 0; i < ids.length; i++) {
    const eid = ids[i];
    internal.members[eid] |= first;
    internal.moreMembers[eid] |= second;
    if (names.length > 0 && eid > world.lastId) internal.lastId = eid;
  }
  countPartialEntities(world, 0, first, ids.length);
  if (names.includes('Attachment')) for (const id of ids) noteNewPart(world, id);
  versions.membership++;
  versions.style++;
  versions.pose++;
}

/**
 * Zeroes all columns of an unused row. They are zero already unless user code wrote through a stale id, which a new
 * entity must not inherit. The function reads first, so that unused pages are not touched.
 */
export function cleanRow(world: PhysicsWorld, eid: number): void {
  const { columns } = world.internal;
  for (let c = 0; c < columns.length; c++) if (columns[c][eid] !== 0) columns[c][eid] = 0;
}

/** Returns the present values of a row. */
export function readRow(world: PhysicsWorld, eid: number, name: ComponentName): FieldValues {
  const columns: Columns = world.components[name];
  const values: FieldValues = {};
  for (const field of Object.keys(columns)) values[field] = columns[field][eid];
  return values;
}

/** Writes validated values to a row in use; does nothing for other rows. */
export function writeRow(world: PhysicsWorld, eid: number, name: ComponentName, values: Readonly<FieldValues>): void {
  if (!isOpen(world, eid, name)) return;
  const columns: Columns = world.components[name];
  for (const field of Object.keys(values)) columns[field][eid] = values[field];
  if (name === 'Attachment' && values.body > 0) noteNewPart(world, eid);
  if (name in world.previous) teleport(world, eid);
  if (name === 'Collider' || (COMPONENTS[name] as ComponentSpec).visual) world.versions.style++;
  if (name === 'Position' || name === 'Velocity') release(world, eid);
}

/** So many new parts are noted; after more of them all parts are looked through. */
export const MAX_NEW_PARTS = 4096;

function noteNewPart({ internal: { newParts } }: PhysicsWorld, part: number): void {
  if (newParts.length < MAX_NEW_PARTS) newParts.push(part);
}

/** Ends the quarantine of a body whose values were corrected. */
function release(world: PhysicsWorld, eid: number): void {
  if (isOpen(world, eid, 'Quarantined')) removeComponent(world, eid, world.components.Quarantined);
}

/** Sets the previous pose of a body to its present pose, so that renderers do not interpolate across the jump. */
export function teleport(world: PhysicsWorld, eid: number): void {
  copyPose(world.components, world.previous, eid);
  world.versions.pose++;
}

/** Zeroes a row: an absent component has zero coefficients, so kernels process its row without a check. */
export function closeRow(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (!isOpen(world, eid, name)) return;
  const { internal, versions } = world;
  toggleBit(world, eid, name);
  internal.counts[name]--;
  const columns: Columns = world.components[name];
  for (const field of Object.keys(columns)) columns[field][eid] = 0;
  if (name in world.previous) teleport(world, eid);
  // The planes of boxWalls are known by their generations, too; that of a body ends with its Position alone.
  if (name === 'Position' || (name === 'PlaneWall' && !isOpen(world, eid, 'Position'))) internal.generations[eid]++;
  if (!isRowUsed(world, eid)) {
    cleanRow(world, eid);
    if (eid === world.lastId) lowerLastId(world);
  }
  versions.membership++;
  versions.style++;
}

function lowerLastId(world: PhysicsWorld): void {
  while (world.lastId > 0 && !isRowUsed(world, world.lastId)) world.internal.lastId--;
}
