// Clears rows of entities that lack a component which a kernel writes to, such as a body with Mass but no Velocity.
import { at } from '../memory/lanes';

// Zeroes the rows of `column` that do not have all the `required` bits.
export function zeroMissing(column: usize, members: usize, required: u32, first: i32, last: i32): void {
  for (let row = first; row < last; row++) {
    if ((load<u32>(members + ((<usize>row) << 2)) & required) != required) store<real>(column + at(row), 0);
  }
}
