// Rows of the columns: initialised when an entity gains a component, and zeroed when it loses it.
import { removeComponent } from 'bitecs';
import { bitOf, COMPONENTS, type ComponentName } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import { type Columns, copyPose } from '../memory/previous-pose.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';
import { countPartialEntities } from './partial-entities.ts';
import { initialValues } from './values.ts';

/** Returns whether the row of a component is in use. */
export function isOpen(world: PhysicsWorld, eid: number, name: ComponentName): boolean {
  return (world.internal.members[eid] & bitOf(name)) !== 0;
}

function changeBits(world: PhysicsWorld, eid: number, bits: number): void {
  const { members } = world.internal;
  countPartialEntities(world, members[eid], bits);
  members[eid] = bits;
}

/** Initialises a row with the initial values of the component. */
export function openRow(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (isOpen(world, eid, name)) return;
  const { internal, versions } = world;
  if (internal.members[eid] === 0) cleanRow(world, eid);
  changeBits(world, eid, internal.members[eid] | bitOf(name));
  internal.counts[name]++;
  if (eid > world.lastId) world.internal.lastId = eid;
  versions.membership++;
  writeRow(world, eid, name, initialValues(name));
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
  if (name in world.previous) teleport(world, eid);
  if (name === 'Collider' || (COMPONENTS[name] as ComponentSpec).visual) world.versions.style++;
  if (name === 'Position' || name === 'Velocity') release(world, eid);
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
  changeBits(world, eid, (internal.members[eid] & ~bitOf(name)) >>> 0);
  internal.counts[name]--;
  const columns: Columns = world.components[name];
  for (const field of Object.keys(columns)) columns[field][eid] = 0;
  if (name in world.previous) teleport(world, eid);
  if (name === 'Position') internal.generations[eid]++;
  if (internal.members[eid] === 0) {
    cleanRow(world, eid);
    if (eid === world.lastId) lowerLastId(world);
  }
  versions.membership++;
  versions.style++;
}

function lowerLastId(world: PhysicsWorld): void {
  const { members } = world.internal;
  while (world.lastId > 0 && members[world.lastId] === 0) world.internal.lastId--;
}
