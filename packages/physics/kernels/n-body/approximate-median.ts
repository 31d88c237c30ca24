// The middle of many sizes. Fields are heavy-tailed: where two bodies meet, theirs outweighs the sum of all others, and a
// mean would say nothing about the rest. In the plane, by 1/r², it has no limit at all.

// Numbers are told apart by their exponent in f64 and the first two digits of what follows it, which begin at this bit.
const DIGIT: u64 = 50;

// @ts-ignore: decorator
@inline export const BINS: i32 = 8192;

// The median of `n` numbers that are not negative, `stride` bytes apart from `at`, without sorting them: up to a fifth too
// small. `counts` has room for BINS whole numbers.
export function middleOf(counts: usize, at: usize, stride: usize, n: i32): f64 {
  memory.fill(counts, 0, (<usize>BINS) << 2);
  for (let i = 0; i < n; i++) {
    const bin = <i32>(reinterpret<u64>(<f64>load<real>(at + <usize>i * stride)) >> DIGIT) & (BINS - 1);
    const count = counts + ((<usize>bin) << 2);
    store<i32>(count, load<i32>(count) + 1);
  }
  let bin = -1;
  for (let below = 0; 2 * below < n; ) below += load<i32>(counts + ((<usize>++bin) << 2));
  return reinterpret<f64>((<u64>bin) << DIGIT);
}
