// The order in which the passes of polylines are solved: the highest tension of the previous sub-step first.
import { get, put } from '../memory/columns';
import { LANES, add, at, laneOf, splat } from '../memory/lanes';
import { ConstraintTable, MAX_PASSES, putWord, word } from './table';

// Sorts the passes; must run while the rows hold the tensions of the previous sub-step. The sort is stable.
export function orderPasses(t: ConstraintTable): void {
  const order = t.passes + ((<usize>(MAX_PASSES + 1)) << 2);
  const tensions = order + ((<usize>(MAX_PASSES + 1)) << 2);
  for (let pass = 0; pass < t.passCount; pass++) {
    const tension = meanTension(t, pass);
    put(tensions, pass, tension);
    let index = pass;
    for (; index > 0; index--) {
      const previous = word(order, index - 1);
      if (get(tensions, previous) >= tension) break;
      putWord(order, index, previous);
    }
    putWord(order, index, pass);
  }
}

// Returns the mean tension of a pass.
function meanTension(t: ConstraintTable, pass: i32): real {
  const first = <i32>word(t.batches, word(t.passes, pass));
  const last = <i32>word(t.batches, word(t.passes, pass + 1));
  let sum = splat(0);
  for (let row = first; row < last; row += LANES) sum = add(sum, v128.load(t.tension + at(row)));
  let tension: real = 0;
  for (let lane = 0; lane < LANES; lane++) tension += laneOf(sum, lane);
  return last > first ? tension / <real>(last - first) : 0;
}
