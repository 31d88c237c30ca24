import type { Addresses } from '../components/all.ts';
import { bitOf } from '../components/membership.ts';
import type { AxisAddresses } from './columns.ts';
import { COLUMN_TABLE, COLUMNS_BYTES, ColumnsWord } from './layouts.gen.ts';

/** Writes the addresses of columns to the table that kernels/memory/columns.ts reads. */
export function writeColumnTable(memory: WebAssembly.Memory, at: Addresses, members: number, realBytes: number): void {
  const table = new Uint32Array(memory.buffer, COLUMN_TABLE, COLUMNS_BYTES / 4);
  const axes = (start: ColumnsWord, { x, y, z }: AxisAddresses) => table.set([x, y, z], start);
  axes(ColumnsWord.positionX, at.Position);
  axes(ColumnsWord.velocityX, at.Velocity);
  axes(ColumnsWord.angularVelocityX, at.AngularVelocity);
  axes(ColumnsWord.orientationX, at.Orientation);
  axes(ColumnsWord.inertiaTensorX, at.InertiaTensor);
  table[ColumnsWord.orientationW] = at.Orientation.w;
  table[ColumnsWord.mass] = at.Mass.value;
  table[ColumnsWord.inertia] = at.Inertia.value;
  table[ColumnsWord.radius] = at.Collider.radius;
  table[ColumnsWord.restitution] = at.Collider.restitution;
  table[ColumnsWord.friction] = at.Collider.friction;
  table[ColumnsWord.layers] = at.Collider.layers;
  table[ColumnsWord.mask] = at.Collider.mask;
  table[ColumnsWord.shape] = at.Collider.shape;
  table[ColumnsWord.members] = members;
  table[ColumnsWord.angularVelocityBit] = bitOf('AngularVelocity');
  table[ColumnsWord.realBytes] = realBytes;
  table[ColumnsWord.tensorBits] = bitOf('AngularVelocity') | bitOf('Orientation') | bitOf('InertiaTensor');
}

/** Writes the addresses of the generations, and of what waits to be a particle, for the kernels. */
export function writeWaiting(memory: WebAssembly.Memory, generations: number, waiting: number): void {
  const table = new Uint32Array(memory.buffer, COLUMN_TABLE, COLUMNS_BYTES / 4);
  table[ColumnsWord.generations] = generations;
  table[ColumnsWord.waiting] = waiting;
}

/** Writes the address of the contact table for the kernels. */
export function writeContactTable(memory: WebAssembly.Memory, at: number): void {
  new Uint32Array(memory.buffer, COLUMN_TABLE, COLUMNS_BYTES / 4)[ColumnsWord.contacts] = at;
}

/** Writes where the shapes of a world lie, and their number. */
export function writeShapePool(memory: WebAssembly.Memory, at: number, count: number): void {
  const table = new Uint32Array(memory.buffer, COLUMN_TABLE, COLUMNS_BYTES / 4);
  table[ColumnsWord.shapes] = at;
  table[ColumnsWord.shapeCount] = count;
}
