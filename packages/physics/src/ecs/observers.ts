// Connects bitECS to the columns: updates a row when a component is added, set or removed.
//
// The connection uses bitECS observers, so the bitECS idiom works unchanged: addComponent(world, eid, set(Position, { x
// })). Edits during a step are deferred to its end.
import { hasComponent, observe, onAdd, onGet, onRemove, onSet, removeComponent } from 'bitecs';
import { COMPONENT_NAMES, type ComponentName, COMPONENTS as DEFINITIONS } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';
import { guardTables } from './bitecs/guard-tables.ts';
import { isLeaving, isPrefab } from './bitecs/remove-entity.ts';
import { recordGenerations } from './body-references.ts';
import { capacityError } from './entity-capacity.ts';
import { whenIdle } from './guards.ts';
import { forgetPending, notePending, pendingValues } from './pending-values.ts';
import { closeRow, isOpen, openRow, readRow, writeRow } from './rows.ts';
import { checkValues, completeValues, initialValues, toInputForm } from './values.ts';

const COMPONENTS: Readonly<Record<ComponentName, ComponentSpec>> = DEFINITIONS;

/** Registers the observers; called once when the world is created. */
export function observeComponents(world: PhysicsWorld): void {
  for (const name of COMPONENT_NAMES) {
    const component = world.components[name];
    observe(world, onAdd(component), (eid: number) => added(world, eid, name));
    observe(world, onSet(component), (eid: number, data: unknown) => assigned(world, eid, name, data));
    observe(world, onRemove(component), (eid: number) => removed(world, eid, name));
    observe(world, onGet(component), (eid: number) => toInputForm(name, presentValues(world, eid, name)));
  }
  guardTables(world);
}

function added(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (eid > world.capacity) {
    removeComponent(world, eid, world.components[name]);
    throw capacityError(world, 1, eid);
  }
  world.internal.justAdded[name] = eid;
  forgetPending(world, eid, name);
  if (isLeaving(world, eid)) return;
  whenIdle(world, () => {
    if (hasComponent(world, eid, world.components[name])) openRow(world, eid, name);
  });
}

function assigned(world: PhysicsWorld, eid: number, name: ComponentName, data: unknown): void {
  const { internal } = world;
  // Invalid values remove the component only if this call added it.
  const isNew = internal.justAdded[name] === eid;
  internal.justAdded[name] = 0;
  let values: FieldValues;
  try {
    values = data === internal.checked ? (data as FieldValues) : checkComplete(world, eid, name, data, isNew);
  } catch (error) {
    if (isNew) removeComponent(world, eid, world.components[name]);
    throw error;
  }
  if (isPrefab(world, eid)) setTemplate(world, eid, name, values);
  else if (!isLeaving(world, eid)) {
    if (COMPONENTS[name].complete !== undefined) notePending(world, eid, name, values);
    whenIdle(world, () => writeValues(world, eid, name, values));
  }
}

/** A body that was spawned in the step has its generation only now, if it has the id of one that was removed in it. */
function writeValues(world: PhysicsWorld, eid: number, name: ComponentName, values: FieldValues): void {
  recordGenerations(world, COMPONENTS[name], values, values);
  writeRow(world, eid, name, values);
}

/**
 * The given values, and those that completing the component changed. The others stay as they are in the row, which other code may write
 * to until the end of a step.
 */
function checkComplete(
  world: PhysicsWorld,
  eid: number,
  name: ComponentName,
  data: unknown,
  isNew: boolean,
): FieldValues {
  const values = checkValues(world, name, data, eid);
  if (COMPONENTS[name].complete === undefined) return values;
  const before = isNew
    ? initialValues(name)
    : { ...presentValues(world, eid, name), ...pendingValues(world, eid, name) };
  const all = completeValues(world, name, values, () => before, eid);
  for (const field of Object.keys(all)) if (field in values || all[field] !== before[field]) values[field] = all[field];
  return values;
}

/** The present values of a component: of a row, of a prefab, or the initial values of a row that is not in use. */
function presentValues(world: PhysicsWorld, eid: number, name: ComponentName): FieldValues {
  if (isOpen(world, eid, name)) return readRow(world, eid, name);
  const template = isPrefab(world, eid) ? world.internal.templates.get(eid)?.[name] : undefined;
  return { ...initialValues(name), ...template };
}

/**
 * A prefab is not a body and has no row, because kernels would move it; the values for its instances are stored
 * separately.
 */
function setTemplate(world: PhysicsWorld, eid: number, name: ComponentName, values: FieldValues): void {
  const { templates } = world.internal;
  const template = templates.get(eid) ?? {};
  template[name] = { ...template[name], ...values };
  templates.set(eid, template);
}

function removed(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (eid > world.capacity) return;
  if (name === 'Position' && world.state === 'stepping') world.internal.edits.departed.add(eid);
  whenIdle(world, () => closeRow(world, eid, name));
}
