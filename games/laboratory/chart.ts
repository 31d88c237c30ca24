import { csvOf, drawDot, drawPath, drawTimeMark, element, rangeAbout, saveText } from '@principia/shell';
import uPlot from 'uplot';
import { createChartCard, lineNames } from './chart-card.ts';
import { type ChartLine, chartLines } from './chart-lines.ts';
import { baseOptions, fitChart } from './chart-options.ts';
import { csvNames } from './csv-names.ts';
import type { LabRun } from './lab-run.ts';
import { plainNumber } from './number-text.ts';
import { Samples } from './samples.ts';
import { SHOWN_PLOTS } from './shown-plots.ts';
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
  readonly #number: number;
  readonly #duration: number;
  readonly #xLabel: string;
  readonly #yLabel: string;
  readonly #isPath: boolean;
  readonly #samples: Samples;
  readonly #card: HTMLElement;
  readonly #readout = element('output', 'lab-readout');
  readonly #names = element('span', '');
  #chart: uPlot;
  #isStale = true;
  /** The marked time, s; not a number while no moment of the past is shown. */
  #mark = Number.NaN;

  /** @param index of the plot in the run */
  constructor(parent: HTMLElement, run: LabRun, index: number, { duration, file }: ChartOptions) {
    const { title, x, y } = run.plots[index];
    this.#run = run;
    this.#number = index + 1;
    this.#duration = duration;
    this.#yLabel = y.label;
    this.#xLabel = x.label;
    this.#lines = chartLines(run, index);
    // Against another quantity than the time, a line may run to and fro, and each has an x of its own.
    this.#isPath = x.label !== 't, s';
    this.#samples = new Samples((this.#isPath ? 2 : 1) * this.#lines.length, duration / SAMPLES);
    const save = () => saveText(`${file}.csv`, this.#csv(), 'text/csv');
    const more = [this.#readout, ...this.#errorButton()];
    this.#card = createChartCard(parent, { title, number: this.#number, save, more, names: this.#names });
    this.#chart = this.#makeChart();
  }

  /** Whether the errors are shown in place of the values. */
  get #showsErrors(): boolean {
    return SHOWN_PLOTS.errors.has(this.#number) && this.#hasErrors;
  }

  get #hasErrors(): boolean {
    return !this.#isPath && this.#lines.some(({ exact }) => exact !== undefined);
  }

  /** The lines on display. */
  get #shown(): readonly ChartLine[] {
    return this.#showsErrors ? this.#lines.filter(({ exact }) => exact !== undefined) : this.#lines;
  }

  #makeChart(): uPlot {
    this.#names.replaceChildren(...lineNames(this.#shown).children);
    const options = this.#isPath ? this.#pathOptions(this.#yLabel) : this.#timeOptions();
    return new uPlot(options, this.#data() as uPlot.AlignedData, this.#card);
  }

  /** Changes between the values and their errors, where the exact solution is known. */
  #errorButton(): HTMLElement[] {
    if (!this.#hasErrors) return [];
    const button = element('button', 'lab-save', { type: 'button', title: WORDS.errorHint }, WORDS.error);
    const show = () => button.setAttribute('aria-pressed', String(this.#showsErrors));
    button.addEventListener('click', () => {
      const { errors } = SHOWN_PLOTS;
      if (!errors.delete(this.#number)) errors.add(this.#number);
      show();
      this.#chart.destroy();
      this.#chart = this.#makeChart();
      this.#isStale = true;
    });
    show();
    return [button];
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
    if (!this.#isStale || this.#chart.root.offsetParent === null) return;
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
    if (this.#isPath) return [null, ...this.#lines.map((_, i) => [values[2 * i], values[2 * i + 1]])];
    return [times, ...this.#shown.map((line) => this.#columnOf(line))];
  }

  /** The values of a line over time, or their errors. */
  #columnOf(line: ChartLine): readonly number[] {
    const [, ...values] = this.#samples.columns;
    const column = values[this.#lines.indexOf(line)];
    if (!this.#showsErrors || line.exact === undefined) return column;
    const exact = values[line.exact];
    return column.map((value, i) => value - exact[i]);
  }

  #csv(): string {
    const labels = this.#lines.map(({ label }) => label);
    const x = this.#isPath ? this.#xLabel : undefined;
    return csvOf(csvNames(labels, this.#yLabel, x), this.#samples.columns);
  }

  #timeOptions(): uPlot.Options {
    const yLabel = this.#showsErrors ? `${WORDS.error}: ${this.#yLabel}` : this.#yLabel;
    return {
      ...baseOptions(this.#xLabel, yLabel),
      cursor: { y: false, points: { size: 6 }, drag: { x: false, y: false } },
      scales: {
        x: { time: false, range: (_, __, high) => [0, Math.max(this.#duration, high)] },
        y: { range: (_, low, high) => rangeAbout(low, high) },
      },
      series: [{}, ...this.#shown.map(({ label, color, width, dash }) => lineOf(label, color, width, dash))],
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
    const [times] = this.#samples.columns;
    const isInside = index !== null && index !== undefined && index < times.length;
    this.#readout.textContent = isInside
      ? `${plainNumber(times[index])} s: ${this.#shown.map((line) => plainNumber(this.#columnOf(line)[index])).join(WORDS.separator)}`
      : '';
  }
}

function lineOf(label: string, stroke: string, width: number, dash: number[] | undefined): uPlot.Series {
  return { label, stroke, width, points: { show: false }, ...(dash === undefined ? {} : { dash }) };
}
