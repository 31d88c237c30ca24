/** Parts of a value by which a range is at least wide: uPlot cannot divide an axis whose labels differ by rounding alone. */
const LEAST = 1e-6;
/** Margin on either side, as a part of the range. */
const MARGIN = 0.06;

/** The range of an axis that shows all values from `low` to `high`; null or infinite while there are none. */
export function rangeAbout(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null || !(low <= high && high - low < Infinity)) return [-1, 1];
  const least = LEAST * Math.max(Math.abs(low), Math.abs(high)) || 1;
  const middle = 0.5 * (low + high);
  const half = Math.max((0.5 + MARGIN) * (high - low), least);
  return [middle - half, middle + half];
}
