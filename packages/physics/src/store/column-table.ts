import { type Addresses, bitOf } from '../components/all';

/** Where the table of column addresses stands in the world's memory; kernels/columns.ts reads it there. */
export const TABLE_ADDRESS = 64;

/** Bytes at the start of the memory that belong to tables. */
export const RESERVED_BYTES = 4096;

/** The words of the table, in the order of the class in kernels/columns.ts. */
export enum TableColumn {
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
  /** How many there are. */
  end,
}

/** Writes the table. */
export function writeColumnTable(memory: WebAssembly.Memory, at: Addresses, members: number): void {
  const { Position, Velocity, Mass, Inertia, AngularVelocity, Collider } = at;
  const table = new Uint32Array(memory.buffer, TABLE_ADDRESS, TableColumn.end);
  table[TableColumn.positionX] = Position.x;
  table[TableColumn.positionY] = Position.y;
  table[TableColumn.positionZ] = Position.z;
  table[TableColumn.velocityX] = Velocity.x;
  table[TableColumn.velocityY] = Velocity.y;
  table[TableColumn.velocityZ] = Velocity.z;
  table[TableColumn.mass] = Mass.value;
  table[TableColumn.inertia] = Inertia.value;
  table[TableColumn.angularVelocityX] = AngularVelocity.x;
  table[TableColumn.angularVelocityY] = AngularVelocity.y;
  table[TableColumn.angularVelocityZ] = AngularVelocity.z;
  table[TableColumn.radius] = Collider.radius;
  table[TableColumn.restitution] = Collider.restitution;
  table[TableColumn.friction] = Collider.friction;
  table[TableColumn.members] = members;
  table[TableColumn.angularVelocityBit] = bitOf('AngularVelocity');
}
