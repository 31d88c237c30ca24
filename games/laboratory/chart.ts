import { csvOf, drawDot, drawPath, drawTimeMark, element, rangeAbout, saveText } from '@principia/shell';
import uPlot from 'uplot';
import { type ChartLine, chartLines } from './chart-lines.ts';
import { baseOptions, fitChart } from './chart-options.ts';
import type { LabRun } from './lab-run.ts';
import { plainNumber } from './number-text.ts';
import { Samples } from './samples.ts';
import { WORDS } from './words.ts';

/** Samples in the duration of an example. */
const SAMPLES = 400;

/** What a chart needs besides its run. */
export interface ChartOptions {
  /** Width of the time axis, s. */
  readonly duration: number;
  /** Name of the file of its numbers, without the ending. */
  readonly file: string;
}

/** A plot of a run: its samples, and those of the ghosts beside it. */
export class Chart {
  readonly #run: LabRun;
  readonly #lines: readonly ChartLine[];
  readonly #xLabel: string;
  readonly #isPath: boolean;
  readonly #samples: Samples;
  readonly #card: HTMLElement;
  readonly #readout = element('output', 'lab-readout');
  readonly #chart: uPlot;
  #isStale = true;
  /** The marked time, s; not a number while no moment of the past is shown. */
  #mark = Number.NaN;

  /** @param index of the plot in the run */
  constructor(parent: HTMLElement, run: LabRun, index: number, { duration, file }: ChartOptions) {
    const { title, x, y } = run.plots[index];
    this.#run = run;
    this.#xLabel = x.label;
    this.#lines = chartLines(run, index);
    // Against another quantity than the time, a line may run to and fro, and each has an x of its own.
    this.#isPath = x.label !== 't, s';
    this.#samples = new Samples((this.#isPath ? 2 : 1) * this.#lines.length, duration / SAMPLES);
    const names = element('span', '');
    names.append(
      ...this.#lines.map(({ label, color, lang }) => element('i', '', { style: `--mark: ${color}`, ...lang }, label)),
    );
    const save = element('button', 'lab-save', { type: 'button', title: WORDS.save }, 'CSV');
    save.addEventListener('click', () => saveText(`${file}.csv`, this.#csv(), 'text/csv'));
    const heading = element('h2', '', {}, element('b', '', { lang: 'en' }, title), this.#readout, save, names);
    this.#card = element('section', 'game-card lab-plot', { 'aria-label': title }, heading);
    parent.append(this.#card);
    const options = this.#isPath ? this.#pathOptions(y.label) : this.#timeOptions(y.label, duration);
    this.#chart = new uPlot(options, this.#data() as uPlot.AlignedData, this.#card);
  }

  /** @param isPast the run stands at a recorded moment: samples are kept, and a line or a dot marks it */
  record(isPast: boolean): void {
    const { time } = this.#run.world;
    const mark = isPast ? time : Number.NaN;
    if (!Object.is(mark, this.#mark)) this.#isStale = true;
    this.#mark = mark;
    if (isPast) return;
    if (this.#samples.discardAfter(time)) this.#isStale = true;
    if (!this.#samples.isDue(time)) return;
    const now = this.#lines.flatMap(({ x, value }) => (this.#isPath ? [x(), value(time)] : [value(time)]));
    this.#samples.add(time, now);
    this.#isStale = true;
  }

  draw(): void {
    if (!this.#isStale || this.#card.offsetParent === null) return;
    this.#isStale = false;
    fitChart(this.#chart, this.#card);
    this.#chart.setData(this.#data() as uPlot.AlignedData);
  }

  destroy(): void {
    this.#chart.destroy();
    this.#card.remove();
  }

  /** uPlot takes one x for all lines, or, for paths, an x and a y for each. */
  #data(): unknown[] {
    const [times, ...values] = this.#samples.columns;
    return this.#isPath ? [null, ...this.#lines.map((_, i) => [values[2 * i], values[2 * i + 1]])] : [times, ...values];
  }

  #csv(): string {
    const names = this.#lines.flatMap(({ label }) => (this.#isPath ? [`${this.#xLabel} (${label})`, label] : [label]));
    return csvOf(['t, s', ...names], this.#samples.columns);
  }

  #timeOptions(yLabel: string, duration: number): uPlot.Options {
    return {
      ...baseOptions(this.#xLabel, yLabel),
      cursor: { y: false, points: { size: 6 }, drag: { x: false, y: false } },
      scales: {
        x: { time: false, range: (_, __, high) => [0, Math.max(duration, high)] },
        y: { range: (_, low, high) => rangeAbout(low, high) },
      },
      series: [{}, ...this.#lines.map(({ label, color, width, dash }) => lineOf(label, color, width, dash))],
      hooks: {
        setCursor: [(chart) => this.#readAt(chart.cursor.idx)],
        draw: [(chart) => drawTimeMark(chart, this.#mark)],
      },
    };
  }

  #pathOptions(yLabel: string): uPlot.Options {
    return {
      ...baseOptions(this.#xLabel, yLabel),
      mode: 2,
      cursor: { show: false },
      hooks: { draw: [(chart) => this.#drawDots(chart)] },
      scales: { x: { time: false, range: () => this.#rangeOf(0) }, y: { range: () => this.#rangeOf(1) } },
      series: [
        {},
        ...this.#lines.map(({ color }): uPlot.Series => ({ stroke: color, paths: drawPath, points: { show: false } })),
      ],
    };
  }

  /** Marks where the paths are at the marked time. */
  #drawDots(chart: uPlot): void {
    const at = this.#samples.lastBefore(this.#mark);
    if (at < 0) return;
    const { columns } = this.#samples;
    for (let i = 0; i < this.#lines.length; i++) {
      drawDot(chart, columns[2 * i + 1][at], columns[2 * i + 2][at], this.#lines[i].color);
    }
  }

  /** Range of the path along an axis, with a margin; 0 for x, 1 for y. */
  #rangeOf(axis: 0 | 1): [number, number] {
    const columns = this.#samples.columns.filter((_, i) => i > 0 && (i - 1) % 2 === axis);
    let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (const column of columns) {
      for (const value of column) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    }
    return rangeAbout(low, high);
  }

  /** Shows the values under the cursor beside the title. */
  #readAt(index: number | null | undefined): void {
    const [times, ...values] = this.#samples.columns;
    const isInside = index !== null && index !== undefined && index < times.length;
    this.#readout.textContent = isInside
      ? `${plainNumber(times[index])} s: ${values.map((column) => plainNumber(column[index])).join(WORDS.separator)}`
      : '';
  }
}

function lineOf(label: string, stroke: string, width: number, dash: number[] | undefined): uPlot.Series {
  return { label, stroke, width, points: { show: false }, ...(dash === undefined ? {} : { dash }) };
}
