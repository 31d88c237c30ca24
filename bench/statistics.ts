/** Statistics of a series of step times. */
export interface Summary {
  readonly min: number;
  readonly median: number;
  readonly p99: number;
}

/** Minimum, median and 99th percentile; NaN for an empty series. */
export function summarise(series: ArrayLike<number>): Summary {
  const sorted = Float64Array.from(series).sort();
  return { min: sorted[0] ?? Number.NaN, median: quantile(sorted, 0.5), p99: quantile(sorted, 0.99) };
}

/** Linear interpolation between the two nearest sorted values. */
function quantile(sorted: Float64Array, fraction: number): number {
  const place = (sorted.length - 1) * fraction;
  const below = Math.floor(place);
  const [low = Number.NaN, high = low] = [sorted[below], sorted[below + 1]];
  return low + (high - low) * (place - below);
}

export function median(series: ArrayLike<number>): number {
  return summarise(series).median;
}

/**
 * Counts of the values in equal bins from the smallest to the 99th percentile, or to `most` where that is less; what is
 * beyond joins the last bin.
 */
export function histogram(
  series: ArrayLike<number>,
  bins: number,
  most = Number.POSITIVE_INFINITY,
): { from: number; to: number; counts: number[] } {
  const { min, p99 } = summarise(series);
  const to = Math.min(p99, most);
  const width = (to - min) / bins;
  const counts = new Array<number>(bins).fill(0);
  for (let i = 0; i < series.length; i++) {
    const bin = width > 0 ? Math.floor(((series[i] as number) - min) / width) : 0;
    const place = Math.min(bins - 1, bin);
    counts[place] = (counts[place] as number) + 1;
  }
  return { from: min, to, counts };
}
