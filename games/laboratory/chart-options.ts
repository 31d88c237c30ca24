/** The looks and the size that all charts share. */
import type uPlot from 'uplot';
import { plainNumber } from './number-text.ts';

/** CSS pixels. */
export const CHART_HEIGHT = 150;
/** Width of a letter of the numbers, CSS pixels. */
const LETTER = 6.4;

/** Gives a chart the width of its card. */
export function fitChart(chart: uPlot, card: HTMLElement): void {
  const width = Math.max(120, card.clientWidth - 24);
  if (width !== chart.width) chart.setSize({ width, height: CHART_HEIGHT });
}

/** Width of the numbers beside a vertical axis, CSS pixels. */
function widthOf(_: uPlot, values: readonly string[] | null): number {
  const letters = Math.max(0, ...(values ?? []).map(({ length }) => length));
  return Math.max(46, 10 + LETTER * letters);
}

/** Axes with names, numbers and a grid. */
export function baseOptions(xLabel: string, yLabel: string) {
  const grid = { stroke: '#ffffff14', width: 1 };
  const font = '11px system-ui, sans-serif';
  const axis = { stroke: '#97a3c7', grid, ticks: { show: false }, font, labelFont: font, labelSize: 14 };
  const values = (_: uPlot, splits: number[]) => splits.map(plainNumber);
  return {
    width: 240,
    height: CHART_HEIGHT,
    padding: [6, 6, 0, 0] as [number, number, number, number],
    legend: { show: false },
    axes: [
      { ...axis, size: 22, values, space: 50, label: xLabel },
      { ...axis, size: widthOf, values, space: 24, label: yLabel },
    ],
  };
}
