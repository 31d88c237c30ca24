// Converts the component bits of the rows into ranges for the step and id lists for renderers.

const BLOCK: i32 = 16;

// Writes ascending ranges [first, last) of whole 16-row blocks with at least one row that has all `required` bits, as
// pairs of i32 at `ranges`, and returns their number. Ranges closer than `gap` blocks are joined: processing a few
// empty rows costs less than another call.
export function buildRanges(members: usize, required: u32, rows: i32, gap: i32, ranges: usize): i32 {
  const requiredBits = i32x4.splat(required);
  let count = 0;
  let last = 0;
  for (let row = 0; row < rows; row += BLOCK) {
    let found = false;
    for (let i = 0; i < BLOCK; i += 4) {
      const bits = v128.and(v128.load(members + ((<usize>(row + i)) << 2)), requiredBits);
      if (v128.any_true(i32x4.eq(bits, requiredBits))) found = true;
    }
    if (!found) continue;
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
