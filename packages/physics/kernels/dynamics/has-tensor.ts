import { columns } from '../memory/columns';

// Returns whether a row has all components of a body that rotates with an inertia tensor.
// @ts-ignore: decorator
@inline export function hasTensor(row: i32): bool {
  const c = columns();
  return (load<u32>(c.members + ((<usize>row) << 2)) & c.tensorBits) == c.tensorBits;
}
