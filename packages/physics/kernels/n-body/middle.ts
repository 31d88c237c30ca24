// The middle of many sizes. Fields are heavy-tailed: where two bodies meet, theirs outweighs the sum of all others, and a
// mean would say nothing about the rest. In the plane, by 1/r², it has no limit at all.

// Numbers of the exponents of f64.
// @ts-ignore: decorator
@inline export const BINS: i32 = 2048;

// @ts-ignore: decorator
@inline function binOf(value: f64): i32 {
  return <i32>(reinterpret<u64>(value) >> 52) & (BINS - 1);
}

// The median of `n` numbers that are not negative, `stride` bytes apart from `at`, without sorting them: the mean of
// those between the same powers of two. `counts` has room for BINS whole numbers.
export function middleOf<T>(counts: usize, at: usize, stride: usize, n: i32): f64 {
  memory.fill(counts, 0, (<usize>BINS) << 2);
  const end = at + <usize>n * stride;
  for (let p = at; p < end; p += stride) {
    const bin = counts + ((<usize>binOf(<f64>load<T>(p))) << 2);
    store<i32>(bin, load<i32>(bin) + 1);
  }
  let middle = -1;
  for (let below = 0; 2 * below < n; ) below += load<i32>(counts + ((<usize>++middle) << 2));
  let sum: f64 = 0;
  for (let p = at; p < end; p += stride) {
    const value = <f64>load<T>(p);
    if (binOf(value) == middle) sum += value;
  }
  return sum / <f64>load<i32>(counts + ((<usize>middle) << 2));
}
