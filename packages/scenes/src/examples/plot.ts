/** The plots of an example. */

/** A line of a plot. */
export interface Series<Run, Values> {
  readonly label: string;
  /** The present value. */
  readonly value: (run: Run) => number;
  /** The exact value at a time, s, drawn as a thin line. */
  readonly exact?: (time: number, values: Values) => number;
}

/** A plot: of the series against time, or of each against the quantity `x`. */
export interface Plot<Run, Values> {
  readonly title: string;
  /** Label and unit of the horizontal axis; default `t, s`. */
  readonly x?: { readonly label: string; readonly value: (run: Run) => number };
  /** Label and unit of the vertical axis. */
  readonly y: { readonly label: string };
  readonly series: readonly Series<Run, Values>[];
}

/** A plot of some quantities against the time. @param axis label and unit of the vertical axis, such as `v, m/s` */
export type PlotOf<Run, Values> = (
  title: string,
  axis: string,
  ...series: readonly Series<Run, Values>[]
) => Plot<Run, Values>;

export function plotOf<Run, Values>(): PlotOf<Run, Values> {
  return (title, axis, ...series) => ({ title, y: { label: axis }, series });
}
