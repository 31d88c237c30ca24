/** The looks of the reader's plot: over time, or of one quantity against another. */
import type uPlot from 'uplot';
import { drawDot, drawPath, drawTimeMark } from './path-plot.ts';
import type { PlotSource } from './plot-sources.ts';
import { rangeAbout } from './range-about.ts';
import { RANGES } from './sampling.ts';
import type { SeriesHistory } from './series-history.ts';
import { siNumber } from './si-number.ts';

/** A unit of one word fits beside the numbers; longer ones stand above. */
export const isCompound = (unit: string): boolean => /[ /]/.test(unit);

const FONT = '11px system-ui, sans-serif';
/** Least width of the numbers beside a plot, and what they keep from it, CSS pixels. */
const LEAST_WIDTH = 46;
const GAP = 8;
/** Least room at the right. */
const LEAST_END = 12;

/** Width of the widest of some numbers, CSS pixels. */
function measured({ ctx }: uPlot, numbers: readonly string[]): number {
  // uPlot remembers the font that it has set.
  ctx.save();
  ctx.font = FONT;
  const widths = numbers.map((number) => Math.ceil(ctx.measureText(number).width));
  ctx.restore();
  return Math.max(0, ...widths);
}

/** Room for the widest number, such as “−200 mm”. @param numbers null before the first ones are known */
const widthOf = (chart: uPlot, numbers: readonly string[] | null): number =>
  Math.max(LEAST_WIDTH, measured(chart, numbers ?? []) + GAP);

/** Room at the right for half of a last number below the very end, such as “100 s”. */
function halfOfLast(chart: uPlot): number {
  const last = Math.floor(chart.scales.x?.max ?? 0);
  return Math.max(LEAST_END, Math.ceil(measured(chart, [secondsText(last)]) / 2));
}

const secondsText = (second: number): string => (second < 0 ? '' : `${second} s`);

function axes(xValues: (value: number) => string, { unit }: PlotSource): uPlot.Axis[] {
  const grid = { stroke: '#ffffff14', width: 1 };
  const axis = { stroke: '#97a3c7', grid, ticks: { show: false }, font: FONT };
  const shown = isCompound(unit) ? '' : unit;
  return [
    { ...axis, size: 20, values: (_, splits) => splits.map(xValues), space: 60 },
    { ...axis, size: widthOf, values: (_, splits) => splits.map((value) => siNumber(value, shown)), space: 28 },
  ];
}

const SIZE = {
  width: 240,
  height: 118,
  legend: { show: false },
  cursor: { show: false },
};

/** The last seconds, and none before the time 0 unless there are rows of it. */
function lastSeconds(low: number, high: number): [number, number] {
  return [Math.min(low, Math.max(0, high - RANGES.time)), Math.max(high, low + 1)];
}

/** @param mark the time where a line is drawn, s, or not a number */
export function timeOptions(source: PlotSource, colors: readonly string[], mark: () => number): uPlot.Options {
  return {
    ...SIZE,
    padding: [6, halfOfLast, 0, 0],
    hooks: { draw: [(chart) => drawTimeMark(chart, mark())] },
    scales: {
      x: { time: false, range: (_, low, high) => lastSeconds(low, high) },
      y: { range: ({ data }) => rangeWithZero(data.slice(1) as Float64Array[]) },
    },
    axes: axes(secondsText, source),
    series: [
      {},
      ...source.series.map((label, i) => ({
        label,
        stroke: colors[i],
        width: 1.5,
        points: { show: false },
        spanGaps: false,
      })),
    ],
  };
}

/**
 * @param history whose last column is the quantity along the horizontal axis
 * @param mark the time where dots are drawn, s, or not a number
 */
export function pathOptions(
  source: PlotSource,
  against: PlotSource,
  colors: readonly string[],
  history: SeriesHistory,
  mark: () => number,
): uPlot.Options {
  const shown = isCompound(against.unit) ? '' : against.unit;
  const count = source.series.length;
  const columns = () => history.data().slice(1);
  return {
    ...SIZE,
    padding: [6, 16, 0, 0],
    mode: 2,
    hooks: {
      draw: [
        (chart) => {
          const at = history.lastBefore(mark());
          const values = columns();
          if (at >= 0) for (let i = 0; i < count; i++) drawDot(chart, values[count][at], values[i][at], colors[i]);
        },
      ],
    },
    scales: {
      x: { time: false, range: () => rangeOf(columns().slice(count)) },
      y: { range: () => rangeOf(columns().slice(0, count)) },
    },
    axes: axes((value) => siNumber(value, shown), source),
    series: [
      {},
      ...source.series.map((_, i): uPlot.Series => ({ stroke: colors[i], paths: drawPath, points: { show: false } })),
    ],
  };
}

/** What uPlot draws: the lines over time, or, in mode 2, an x and a y for each line. */
export function plotData(history: SeriesHistory, isPath: boolean): uPlot.AlignedData {
  const [times, ...columns] = history.data();
  if (!isPath) return [times, ...columns];
  const x = columns.pop();
  return [null, ...columns.map((y) => [x, y])] as unknown as uPlot.AlignedData;
}

/** The least and the largest of all values; those that are not numbers yet do not count. */
function extremes(columns: readonly Float64Array[]): [number, number] {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const column of columns) {
    for (const value of column) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

/** The range of all values, with a margin. */
function rangeOf(columns: readonly Float64Array[]): [number, number] {
  return rangeAbout(...extremes(columns));
}

/** The range includes zero, with a margin on either side. */
function rangeWithZero(columns: readonly Float64Array[]): [number, number] {
  const [low, high] = extremes(columns);
  if (!Number.isFinite(low + high)) return [0, 1];
  const [bottom, top] = [Math.min(0, low), Math.max(0, high)];
  return bottom === top ? [0, 1] : [bottom * 1.08, top * 1.08];
}
