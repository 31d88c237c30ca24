import { type Addresses, COMPONENT_NAMES, COMPONENTS, type ComponentName, type Components } from '../components/all.ts';
import type { FieldSpec, RealColumn } from '../components/define.ts';
import type { Precision } from '../kernels/instantiate.ts';
import { type Arena, allocate } from './arena.ts';
import { AXES } from './axes.ts';

/** Bytes of one real number. */
export function realBytes(precision: Precision): number {
  return precision === 'f32' ? 4 : 8;
}

/** Allocates a column of reals and returns it with its address. */
export function realColumn(arena: Arena, precision: Precision, rows: number, what: string): [RealColumn, number] {
  const address = allocate(arena, rows * realBytes(precision), what);
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  return [new Column(arena.memory.buffer, address, rows), address];
}

/** Allocates a column of unsigned integers and returns it with its address. */
export function wordColumn(arena: Arena, rows: number, what: string): [Uint32Array, number] {
  const address = allocate(arena, rows * 4, what);
  return [new Uint32Array(arena.memory.buffer, address, rows), address];
}

/** Real columns for x, y and z. */
export interface AxisColumns {
  readonly x: RealColumn;
  readonly y: RealColumn;
  readonly z: RealColumn;
}

/** The addresses of such columns. */
export interface AxisAddresses {
  x: number;
  y: number;
  z: number;
}

/** Allocates three real columns, one per axis. */
export function axisColumns(
  arena: Arena,
  precision: Precision,
  rows: number,
  what: string,
): [AxisColumns, AxisAddresses] {
  const [columns, starts] = named(AXES[3], (axis) => realColumn(arena, precision, rows, `${what}.${axis}`));
  return [columns, starts];
}

/** Allocates the columns of all components, or of the named ones. */
export function componentColumns<Name extends ComponentName = ComponentName>(
  arena: Arena,
  precision: Precision,
  rows: number,
  names: readonly ComponentName[] = COMPONENT_NAMES,
): [Pick<Components, Name>, Pick<Addresses, Name>] {
  return named(names, (name) => {
    const fields: Readonly<Record<string, FieldSpec>> = COMPONENTS[name].fields;
    const made = named(Object.keys(fields), (field): [RealColumn | Uint32Array, number] => {
      const what = `${name}.${field}`;
      return fields[field].kind === 'real' ? realColumn(arena, precision, rows, what) : wordColumn(arena, rows, what);
    });
    // Frozen, so that `Velocity.x = 5`, which lacks an index, throws instead of replacing the column.
    return [Object.freeze(made[0]), made[1]] as const;
  }) as unknown as [Pick<Components, Name>, Pick<Addresses, Name>];
}

/** Calls `make` for each name and returns columns and addresses by name. */
function named<Name extends string, Column, Address>(
  names: readonly Name[],
  make: (name: Name) => readonly [Column, Address],
): [Record<Name, Column>, Record<Name, Address>] {
  const made = names.map((name) => [name, ...make(name)] as const);
  return [
    Object.fromEntries(made.map(([name, column]) => [name, column])),
    Object.fromEntries(made.map(([name, , address]) => [name, address])),
  ] as [Record<Name, Column>, Record<Name, Address>];
}

/** Addresses of all real columns of a component. */
export function realAddresses(addresses: Addresses, name: ComponentName): readonly number[] {
  const starts = addresses[name] as Readonly<Record<string, number>>;
  const fields = Object.entries(COMPONENTS[name].fields).filter(([, { kind }]) => kind === 'real');
  return fields.map(([field]) => starts[field]);
}

/**
 * The number of real and word columns of all components, or of the named ones; it determines the size of the memory.
 */
export function columnCounts(names: readonly ComponentName[] = COMPONENT_NAMES): { reals: number; words: number } {
  const fields = names.flatMap((name) => Object.values<FieldSpec>(COMPONENTS[name].fields));
  const reals = fields.filter(({ kind }) => kind === 'real').length;
  return { reals, words: fields.length - reals };
}
