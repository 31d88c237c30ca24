// The table of column addresses at the start of the world's memory, for kernels that use too many columns to pass
// each as a parameter. src/memory/column-table.ts writes it.
import { COLUMN_TABLE } from './low-memory-map';

@unmanaged
export class Columns {
  positionX: usize;
  positionY: usize;
  positionZ: usize;
  velocityX: usize;
  velocityY: usize;
  velocityZ: usize;
  mass: usize;
  inertia: usize;
  angularVelocityX: usize;
  angularVelocityY: usize;
  angularVelocityZ: usize;
  radius: usize;
  restitution: usize;
  friction: usize;
  layers: usize;
  mask: usize;
  members: usize;
  // The bit of AngularVelocity in `members`, and the address of the contact table (kernels/particle-contacts/table.ts),
  // 0 if there is none.
  angularVelocityBit: u32;
  contacts: usize;
  // Column `Collider.shape`; the first record of the shape pool (kernels/collision/shapes/2d/shape.ts) and the number of
  // its records, both 0 while the world has no shape but circles. Index 0 belongs to none.
  shape: usize;
  shapes: usize;
  shapeCount: i32;
  orientationX: usize;
  orientationY: usize;
  orientationZ: usize;
  orientationW: usize;
  inertiaTensorX: usize;
  inertiaTensorY: usize;
  inertiaTensorZ: usize;
  // The bits of the components that a body with a rotating inertia tensor has.
  tensorBits: u32;
  // Bytes of a real number: 4 or 8, for kernels that are compiled for both precisions at once.
  realBytes: i32;
  // The generation of each row; and, in a world with emitters, that of what waits there to be a particle, plus 1.
  generations: usize;
  waiting: usize;
}

// @ts-ignore: decorator
@inline export function columns(): Columns {
  return changetype<Columns>(COLUMN_TABLE);
}

// @ts-ignore: decorator
@inline export function get(column: usize, row: i32): real {
  return load<real>(column + <usize>row * sizeof<real>());
}

// @ts-ignore: decorator
@inline export function put(column: usize, row: i32, value: real): void {
  store<real>(column + <usize>row * sizeof<real>(), value);
}

// Returns whether a row waits in the pool of an emitter. It has a position, but nothing is there.
// @ts-ignore: decorator
@inline export function isWaiting(row: i32): bool {
  const c = columns();
  const at = (<usize>row) << 2;
  return c.waiting != 0 && load<u32>(c.waiting + at) == load<u32>(c.generations + at) + 1;
}
