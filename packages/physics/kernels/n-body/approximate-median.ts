// Approximate median. Field magnitudes are heavy-tailed: a close pair can outweigh the sum of all other bodies, so the
// mean is not representative. In the plane with 1/r² the mean does not even converge.

// Bins are formed by the f64 exponent and the first two mantissa bits, which begin at this bit.
const BIN_SHIFT: u64 = 50;

// @ts-ignore: decorator
@inline export const BINS: i32 = 8192;

// Returns the median of `n` non-negative numbers, `stride` bytes apart from `at`, without sorting; it is up to a fifth
// too small. `counts` has space for BINS integers.
export function approximateMedian(counts: usize, at: usize, stride: usize, n: i32): f64 {
  memory.fill(counts, 0, (<usize>BINS) << 2);
  for (let i = 0; i < n; i++) {
    const bin = <i32>(reinterpret<u64>(<f64>load<real>(at + <usize>i * stride)) >> BIN_SHIFT) & (BINS - 1);
    const count = counts + ((<usize>bin) << 2);
    store<i32>(count, load<i32>(count) + 1);
  }
  let bin = -1;
  for (let below = 0; 2 * below < n; ) below += load<i32>(counts + ((<usize>++bin) << 2));
  return reinterpret<f64>((<u64>bin) << BIN_SHIFT);
}
