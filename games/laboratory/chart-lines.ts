import type { LabRun } from './lab-run.ts';
import { WORDS } from './words.ts';

const COLORS = ['#ff8f7a', '#6db7ff', '#ffd98a', '#7be0ad', '#c3a6ff'];
const ENGLISH = { lang: 'en' };
const EXACT = { color: '#eef1fb', width: 1, dash: [4, 4] };

/** A line of a chart. */
export interface ChartLine {
  readonly label: string;
  /** The language of a label of the example's own. */
  readonly lang?: { readonly lang: string };
  readonly color: string;
  /** CSS pixels. */
  readonly width: number;
  readonly dash?: number[];
  /** The present value along the horizontal axis. */
  readonly x: () => number;
  /** Index of the line of its exact values, if they are known. */
  readonly exact?: number;
  /** The value at a time, s, which is the present one. */
  readonly value: (time: number) => number;
}

/** The lines of a plot: each series and its exact value, and the last series of each ghost. */
export function chartLines({ plots, ghosts }: LabRun, index: number): ChartLine[] {
  const x = plots[index].x.value;
  const own: ChartLine[] = [];
  for (const [i, { label, value, exact }] of plots[index].series.entries()) {
    const line = { label, lang: ENGLISH, color: COLORS[i % COLORS.length], width: 1.6, x, value };
    if (exact === undefined) own.push(line);
    else own.push({ ...line, exact: own.length + 1 }, { ...EXACT, label: WORDS.exact, x, value: exact });
  }
  const reference = plots[index].series.at(-1)?.exact === undefined ? {} : { exact: own.length - 1 };
  const others = ghosts.members.flatMap(({ label, color, run }): ChartLine[] => {
    const plot = run.plots[index];
    const last = plot.series.at(-1);
    if (last === undefined) return [];
    const { value } = last;
    return [
      {
        ...reference,
        label,
        color: `#${color.toString(16).padStart(6, '0')}`,
        width: 1.2,
        dash: [2, 2],
        x: plot.x.value,
        value,
      },
    ];
  });
  return [...own, ...others];
}
