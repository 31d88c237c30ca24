// Custom components whose columns are in the world's memory: laws read them, snapshots save them, and bitECS adds and
// removes them like built-in components.
import { observe, onAdd, onGet, onRemove, onSet, removeComponent } from 'bitecs';
import { nameOfDefinition } from '../components/all.ts';
import { type ColumnsOf, type ComponentSpec, type FieldSpec, isComponent } from '../components/define.ts';
import { MAX_OWN_BITS, ownBitAt } from '../components/membership.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkList, checkNumber, mustBe } from '../errors/validate.ts';
import type { Precision } from '../kernels/instantiate.ts';
import type { Arena } from '../memory/arena.ts';
import { realColumn, wordColumn } from '../memory/columns.ts';
import type { OwnColumns, OwnComponents, PhysicsWorld } from '../world/types.ts';
import { registerColumns } from './bitecs/guard-tables.ts';
import { capacityError } from './entity-capacity.ts';
import { assertUsable, whenIdle } from './guards.ts';
import { isStored, refuseNumber } from './values.ts';

/**
 * @throws PhysicsError E_TYPE if the argument is not a list of components
 */
export function checkOwnComponents(components: unknown): readonly ComponentSpec[] {
  checkList(components, 'components');
  const list = (components ?? []) as readonly unknown[];
  list.forEach((component, i) => {
    if (!isComponent(component)) throw mustBe('a component made by defineComponent', component, `components[${i}]`);
    checkOwnComponent(component, `components[${i}]`);
  });
  return list as readonly ComponentSpec[];
}

function builtInError(what: string, name: string): PhysicsError {
  return new PhysicsError('E_TYPE', `${what} is ${name}, which every world has.`, {
    field: 'components',
    hint: `Use world.components.${name}.`,
  });
}

function checkOwnComponent(component: ComponentSpec, place: string): void {
  const builtIn = nameOfDefinition(component);
  if (builtIn !== undefined) throw builtInError(place, builtIn);
  for (const [name, field] of Object.entries<FieldSpec>(component.fields)) {
    const what = `the field ${name} of ${place}`;
    if (field?.kind !== 'real' && field?.kind !== 'u32') throw mustBe('made by realField or wordField', field, what);
    checkKeys(field.bounds, what, ['min', 'max', 'above', 'integer', 'hint'], 'bound');
    checkNumber(field.initial, `the initial value of ${what}`, field.bounds);
  }
}

/** The number of columns of the components. */
export function ownColumnCount(components: readonly ComponentSpec[]): number {
  return components.reduce((sum, { fields }) => sum + Object.keys(fields).length, 0);
}

/** Allocates the columns of the components that a world is created with. */
export function makeOwnColumns(
  arena: Arena,
  precision: Precision,
  rows: number,
  components: readonly ComponentSpec[],
): OwnComponents {
  return new Map(
    components.map((component, place): [ComponentSpec, OwnColumns] => {
      const made = Object.entries<FieldSpec>(component.fields).map(([field, { kind }]) => {
        const [column, address] =
          kind === 'real' ? realColumn(arena, precision, rows, field) : wordColumn(arena, rows, field);
        return [field, column, address] as const;
      });
      const columns = Object.freeze(Object.fromEntries(made.map(([field, column]) => [field, column])));
      return [
        component,
        {
          columns,
          addresses: Object.fromEntries(made.map(([field, , address]) => [field, address])),
          bit: ownBitAt(place),
        },
      ];
    }),
  );
}

/** Registers observers that fill and clear the rows; called once when the world is created. */
export function observeOwnComponents(world: PhysicsWorld): void {
  const { moreMembers } = world.internal;
  for (const [{ fields }, { columns, bit }] of world.internal.ownComponents) {
    registerColumns(world, columns);
    const change = (isMember: boolean) => (eid: number) => {
      if (eid > world.capacity) {
        if (!isMember) return;
        removeComponent(world, eid, columns);
        throw capacityError(world, 1, eid);
      }
      whenIdle(world, () => {
        moreMembers[eid] = isMember ? moreMembers[eid] | bit : moreMembers[eid] & ~bit;
        for (const field of Object.keys(columns)) columns[field][eid] = isMember ? fields[field].initial : 0;
      });
    };
    observe(world, onAdd(columns), change(true));
    observe(world, onRemove(columns), change(false));
    // bitECS asks for the values of a prefab, which it gives to its instances.
    observe(world, onGet(columns), (eid: number) =>
      Object.fromEntries(Object.keys(columns).map((field) => [field, columns[field][eid]])),
    );
    observe(world, onSet(columns), (eid: number, data: unknown) => {
      const values = checkedValues(world.precision, fields, data, eid);
      whenIdle(world, () => {
        for (const field of Object.keys(values)) columns[field][eid] = values[field];
      });
    });
  }
}

function checkedValues(
  precision: Precision,
  fields: Readonly<Record<string, FieldSpec>>,
  data: unknown,
  entity: number,
): Record<string, number> {
  checkKeys(data, 'a component', Object.keys(fields), 'field');
  return Object.fromEntries(
    Object.entries(data as object).map(([field, value]) => {
      const spec = fields[field];
      return [field, isStored(precision, spec, value) ? value : refuseNumber(spec, field, value, entity)];
    }),
  );
}

/**
 * Returns the columns of a custom component, one typed array per field: a bitECS component that can be added, set and
 * removed.
 * @throws PhysicsError E_UNKNOWN if the world was created without it, E_TYPE, E_DESTROYED
 */
export function columnsOf<const Spec extends ComponentSpec>(world: PhysicsWorld, component: Spec): ColumnsOf<Spec> {
  assertUsable(world);
  return ownColumns(world, component).columns as ColumnsOf<Spec>;
}

/**
 * @throws PhysicsError E_UNKNOWN if the world was created without it
 */
export function ownColumns({ internal }: PhysicsWorld, component: ComponentSpec): OwnColumns {
  const found = internal.ownComponents.get(component);
  if (found !== undefined) return found;
  const name = nameOfDefinition(component);
  if (name !== undefined) throw builtInError('columnsOf: the component', name);
  const fields = Object.keys(component?.fields ?? {}).join(', ');
  throw new PhysicsError('E_UNKNOWN', `this world was created without the component {${fields}}.`, {
    field: 'components',
    hint: 'Pass it to createPhysicsWorld: createPhysicsWorld({ components: [MyComponent] }).',
  });
}

/**
 * The bit of a custom component in the second word of membership.
 * @throws PhysicsError E_UNKNOWN if the world was created without it, E_RANGE if no bit was left for it
 */
export function ownBit(world: PhysicsWorld, component: ComponentSpec): number {
  const { bit } = ownColumns(world, component);
  if (bit !== 0) return bit;
  throw new PhysicsError('E_RANGE', `forces cannot ask for this component: list it among the first ${MAX_OWN_BITS}.`);
}
