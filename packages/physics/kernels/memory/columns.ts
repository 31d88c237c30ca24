// The table of column addresses at the start of the world's memory, for kernels that use too many columns to pass each
// as a parameter. src/memory/column-table.ts writes it in this order; a test compares the two.

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
  members: usize;
  // The bit of AngularVelocity in `members`, and the address of the contact table (kernels/particle-contacts/table.ts),
  // 0 if there is none.
  angularVelocityBit: u32;
  contacts: usize;
}

const TABLE: usize = 64;

// @ts-ignore: decorator
@inline export function columns(): Columns {
  return changetype<Columns>(TABLE);
}

// @ts-ignore: decorator
@inline export function get(column: usize, row: i32): real {
  return load<real>(column + <usize>row * sizeof<real>());
}

// @ts-ignore: decorator
@inline export function put(column: usize, row: i32, value: real): void {
  store<real>(column + <usize>row * sizeof<real>(), value);
}

// Returns the end of the compiler's constants in the first bytes of the memory: they must stay below the first column.
export function staticEnd(): usize {
  return __heap_base;
}
