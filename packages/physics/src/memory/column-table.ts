import { type Addresses, bitOf } from '../components/all.ts';
import type { AxisAddresses } from './columns.ts';

/** Address of the table of column addresses in the world's memory; kernels/memory/columns.ts reads it there. */
export const TABLE_ADDRESS = 64;

/** Bytes at the start of the memory that are reserved for tables. */
export const RESERVED_BYTES = 4096;

/** The words of the table, in the order of the class in kernels/memory/columns.ts. */
export const enum TableColumn {
  positionX,
  positionY,
  positionZ,
  velocityX,
  velocityY,
  velocityZ,
  mass,
  inertia,
  angularVelocityX,
  angularVelocityY,
  angularVelocityZ,
  radius,
  restitution,
  friction,
  members,
  angularVelocityBit,
  contacts,
  /** The number of words. */
  end,
}

/** Writes the table. */
export function writeColumnTable(memory: WebAssembly.Memory, at: Addresses, members: number): void {
  const table = new Uint32Array(memory.buffer, TABLE_ADDRESS, TableColumn.end);
  const axes = (start: TableColumn, { x, y, z }: AxisAddresses) => table.set([x, y, z], start);
  axes(TableColumn.positionX, at.Position);
  axes(TableColumn.velocityX, at.Velocity);
  axes(TableColumn.angularVelocityX, at.AngularVelocity);
  table[TableColumn.mass] = at.Mass.value;
  table[TableColumn.inertia] = at.Inertia.value;
  table[TableColumn.radius] = at.Collider.radius;
  table[TableColumn.restitution] = at.Collider.restitution;
  table[TableColumn.friction] = at.Collider.friction;
  table[TableColumn.members] = members;
  table[TableColumn.angularVelocityBit] = bitOf('AngularVelocity');
}
