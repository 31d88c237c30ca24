// Connects bitECS to the columns: updates a row when a component is added, set or removed.
//
// The connection uses bitECS observers, so the bitECS idiom works unchanged: addComponent(world, eid, set(Position, { x
// })). Edits during a step are deferred to its end.
import { hasComponent, observe, onAdd, onGet, onRemove, onSet, removeComponent } from 'bitecs';
import { COMPONENT_NAMES, type ComponentName } from '../components/all.ts';
import type { FieldValues, PhysicsWorld } from '../world/types.ts';
import { guardTables } from './bitecs/guard-tables.ts';
import { isLeaving, isPrefab } from './bitecs/remove-entity.ts';
import { capacityError } from './entity-capacity.ts';
import { whenIdle } from './guards.ts';
import { closeRow, isOpen, openRow, readRow, writeRow } from './rows.ts';
import { checkValues, completeValues, initialValues, toInputForm } from './values.ts';

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
    values = data === internal.checked ? (data as FieldValues) : checkComplete(world, eid, name, data);
  } catch (error) {
    if (isNew) removeComponent(world, eid, world.components[name]);
    throw error;
  }
  if (isPrefab(world, eid)) setTemplate(world, eid, name, values);
  else if (!isLeaving(world, eid)) whenIdle(world, () => writeRow(world, eid, name, values));
}

function checkComplete(world: PhysicsWorld, eid: number, name: ComponentName, data: unknown): FieldValues {
  const values = checkValues(world, name, data, eid);
  return completeValues(world, name, values, () => presentValues(world, eid, name), eid);
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
  if (eid <= world.capacity) whenIdle(world, () => closeRow(world, eid, name));
}
