// Processors compute with subnormal numbers in microcode: a step in which all velocities are subnormal takes some fifty
// times as long. A velocity that decays ends there for good, where the next reduction is less than half of the last bit.
import { LANES, at, splat } from '../memory/lanes';

// Sets what is nearer to zero than `limit` to zero.
export function flushToZero(column: usize, limit: real, first: i32, last: i32): void {
  const least = splat(limit);
  for (let row = first; row < last; row += LANES) {
    const place = column + at(row);
    const values = v128.load(place);
    const tiny = v128.and(v128.lt<real>(v128.abs<real>(values), least), v128.ne<real>(values, splat(0)));
    if (v128.any_true(tiny)) v128.store(place, v128.andnot(values, tiny));
  }
}
