/**
 * The density of some numbers in each of `count` equal intervals from `min` to `max`: the share of all numbers that is in
 * it, divided by its width. A number at a border belongs to the interval above it; without numbers every density is 0.
 */
export function densities(samples: ArrayLike<number>, min: number, max: number, count: number): Float64Array {
  const result = new Float64Array(count);
  const width = (max - min) / count;
  const unit = 1 / (samples.length * width);
  for (let i = 0; i < samples.length; i++) {
    const interval = Math.floor((samples[i] - min) / width);
    if (interval >= 0 && interval < count) result[interval] += unit;
  }
  return result;
}
