// Converts the component bits of the rows into ranges for the step and id lists for renderers.

import { columns } from '../memory/columns';

const BLOCK: i32 = 16;

// Writes ascending ranges [first, last) of whole 16-row blocks with at least one row that has all `required` bits, as
// pairs of i32 at `ranges`, and returns their number. Ranges closer than `gap` blocks are joined: processing a few
// empty rows costs less than another call. With `skipsWaiting` 1, rows that wait to be a particle do not count.
export function buildRanges(members: usize, required: u32, rows: i32, gap: i32, ranges: usize, skipsWaiting: i32): i32 {
  const requiredBits = i32x4.splat(required);
  const skips = skipsWaiting != 0 && columns().waiting != 0;
  let count = 0;
  let last = 0;
  for (let row = 0; row < rows; row += BLOCK) {
    let found = i32x4.splat(0);
    for (let i = row; i < row + BLOCK; i += 4) {
      const bits = v128.and(v128.load(members + ((<usize>i) << 2)), requiredBits);
      const has = i32x4.eq(bits, requiredBits);
      found = v128.or(found, skips ? v128.andnot(has, areWaiting(i)) : has);
    }
    if (!v128.any_true(found)) continue;
    if (count > 0 && row - last <= gap * BLOCK) {
      store<i32>(ranges + ((<usize>(count - 1)) << 3), row + BLOCK, 4);
    } else {
      store<i32>(ranges + ((<usize>count) << 3), row);
      store<i32>(ranges + ((<usize>count) << 3), row + BLOCK, 4);
      count++;
    }
    last = row + BLOCK;
  }
  return count;
}

// Which of four rows wait to be a particle, as isWaiting tells of one.
// @ts-ignore: decorator
@inline function areWaiting(row: i32): v128 {
  const at = (<usize>row) << 2;
  const next = i32x4.add(v128.load(columns().generations + at), i32x4.splat(1));
  return i32x4.eq(v128.load(columns().waiting + at), next);
}

// Writes the ids of all rows with all `required` bits in ascending order, and returns their number.
export function collectEntities(members: usize, required: u32, rows: i32, ids: usize): i32 {
  let count = 0;
  for (let row = 0; row < rows; row++) {
    if ((load<u32>(members + ((<usize>row) << 2)) & required) == required) {
      store<u32>(ids + ((<usize>count) << 2), row);
      count++;
    }
  }
  return count;
}
