import { type Addresses, COMPONENT_NAMES, COMPONENTS, type ComponentName, type Components } from '../components/all';
import type { RealColumn } from '../components/define';
import type { Precision } from '../kernels/instantiate';
import type { PhysicsWorld } from '../world';
import { type Arena, allocate } from './arena';

/** Bytes of one real number. */
export function realBytes(precision: Precision): number {
  return precision === 'f32' ? 4 : 8;
}

/** A new column of reals and its address. */
export function realColumn(arena: Arena, precision: Precision, rows: number, what: string): [RealColumn, number] {
  const address = allocate(arena, rows * realBytes(precision), what);
  const Column = precision === 'f32' ? Float32Array : Float64Array;
  return [new Column(arena.memory.buffer, address, rows), address];
}

/** A new column of unsigned integers and its address. */
export function wordColumn(arena: Arena, rows: number, what: string): [Uint32Array, number] {
  const address = allocate(arena, rows * 4, what);
  return [new Uint32Array(arena.memory.buffer, address, rows), address];
}

/** One x, y, z triple of real columns. */
export interface AxisColumns {
  readonly x: RealColumn;
  readonly y: RealColumn;
  readonly z: RealColumn;
}

/** Their addresses. */
export interface AxisAddresses {
  x: number;
  y: number;
  z: number;
}

/** Three real columns, one an axis. */
export function axisColumns(
  arena: Arena,
  precision: Precision,
  rows: number,
  what: string,
): [AxisColumns, AxisAddresses] {
  const [x, ax] = realColumn(arena, precision, rows, `${what}.x`);
  const [y, ay] = realColumn(arena, precision, rows, `${what}.y`);
  const [z, az] = realColumn(arena, precision, rows, `${what}.z`);
  return [
    { x, y, z },
    { x: ax, y: ay, z: az },
  ];
}

/** The columns of every component. */
export function componentColumns(arena: Arena, precision: Precision, rows: number): [Components, Addresses] {
  const components: Record<string, Record<string, RealColumn | Uint32Array>> = {};
  const addresses: Record<string, Record<string, number>> = {};
  for (const name of COMPONENT_NAMES) {
    const columns: Record<string, RealColumn | Uint32Array> = {};
    const starts: Record<string, number> = {};
    for (const [field, spec] of Object.entries(COMPONENTS[name].fields)) {
      const what = `${name}.${field}`;
      const [column, address] =
        spec.kind === 'real' ? realColumn(arena, precision, rows, what) : wordColumn(arena, rows, what);
      columns[field] = column;
      starts[field] = address;
    }
    components[name] = columns;
    addresses[name] = starts;
  }
  return [components as unknown as Components, addresses as unknown as Addresses];
}

/** Addresses of all real columns of a component. */
export function realAddresses({ addresses }: PhysicsWorld, name: ComponentName): readonly number[] {
  const starts = addresses[name] as Readonly<Record<string, number>>;
  const fields = Object.entries(COMPONENTS[name].fields).filter(([, { kind }]) => kind === 'real');
  return fields.map(([field]) => starts[field]);
}

/** How many real and word columns the components have together: what the memory is sized by. */
export function columnCounts(): { reals: number; words: number } {
  let reals = 0;
  let words = 0;
  for (const name of COMPONENT_NAMES) {
    for (const spec of Object.values(COMPONENTS[name].fields)) {
      if (spec.kind === 'real') reals++;
      else words++;
    }
  }
  return { reals, words };
}
