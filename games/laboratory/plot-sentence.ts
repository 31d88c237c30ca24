import type { LivePlot } from '@principia/scenes/examples';
import { plainNumber } from './number-text.ts';

/** What a plot shows now: its title, and of each of its series the label, the value and the unit, which follows the comma of the axis. */
export function plotSentence({ title, y, series }: Pick<LivePlot, 'title' | 'y' | 'series'>): string {
  const [, unit = ''] = y.label.split(', ');
  const values = series.map(({ label, value }) => `${label} ${plainNumber(value()).replace(',', '.')} ${unit}`.trim());
  return `${title}: ${values.join(', ')}`;
}
