import { type Addresses, bitOf } from '../components/all';

/** Where the table of column addresses stands in the world's memory; kernels/columns.ts reads it there. */
export const TABLE_ADDRESS = 64;

/** Bytes at the start of the memory that belong to tables. */
export const RESERVED_BYTES = 4096;

/** The columns of the table, in the order of the class in kernels/columns.ts. */
export const TABLE_COLUMNS = [
  'positionX',
  'positionY',
  'positionZ',
  'velocityX',
  'velocityY',
  'velocityZ',
  'mass',
  'inertia',
  'angularVelocityX',
  'angularVelocityY',
  'angularVelocityZ',
  'radius',
  'restitution',
  'friction',
  'members',
  'angularVelocityBit',
  'contacts',
] as const;

/** Writes the table. */
export function writeColumnTable(memory: WebAssembly.Memory, at: Addresses, members: number): void {
  const { Position, Velocity, Mass, Inertia, AngularVelocity, Collider } = at;
  const table: Record<(typeof TABLE_COLUMNS)[number], number> = {
    positionX: Position.x,
    positionY: Position.y,
    positionZ: Position.z,
    velocityX: Velocity.x,
    velocityY: Velocity.y,
    velocityZ: Velocity.z,
    mass: Mass.value,
    inertia: Inertia.value,
    angularVelocityX: AngularVelocity.x,
    angularVelocityY: AngularVelocity.y,
    angularVelocityZ: AngularVelocity.z,
    radius: Collider.radius,
    restitution: Collider.restitution,
    friction: Collider.friction,
    members,
    angularVelocityBit: bitOf('AngularVelocity'),
    contacts: 0,
  };
  new Uint32Array(memory.buffer, TABLE_ADDRESS, TABLE_COLUMNS.length).set(TABLE_COLUMNS.map((name) => table[name]));
}
