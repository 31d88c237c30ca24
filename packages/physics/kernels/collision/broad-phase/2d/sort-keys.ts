// Sorts `count` keys of u64 by merging runs of growing length; `spare` is a buffer of the same size. A nearly sorted list, such as
// the pairs found in ascending order of ids, costs little more than a copy.
export function sortKeys(keys: usize, spare: usize, count: i32): void {
  let from = keys;
  let to = spare;
  for (let width = 1; width < count; width <<= 1) {
    for (let first = 0; first < count; first += 2 * width) {
      mergeRuns(from, to, first, min<i32>(first + width, count), min<i32>(first + 2 * width, count));
    }
    const swapped = from;
    from = to;
    to = swapped;
  }
  if (from != keys) memory.copy(keys, from, (<usize>count) << 3);
}

function mergeRuns(from: usize, to: usize, first: i32, middle: i32, last: i32): void {
  let a = first;
  let b = middle;
  for (let i = first; i < last; i++) {
    const takesA = b >= last || (a < middle && keyAt(from, a) <= keyAt(from, b));
    store<u64>(to + ((<usize>i) << 3), keyAt(from, takesA ? a : b));
    if (takesA) a++;
    else b++;
  }
}

// @ts-ignore: decorator
@inline export function keyAt(keys: usize, i: i32): u64 {
  return load<u64>(keys + ((<usize>i) << 3));
}
