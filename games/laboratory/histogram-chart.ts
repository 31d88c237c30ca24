import type { LiveHistogram } from '@principia/scenes/examples';
import { csvOf, saveText } from '@principia/shell';
import uPlot from 'uplot';
import { createChartCard, lineNames } from './chart-card.ts';
import { baseOptions, fitChart } from './chart-options.ts';
import { WORDS } from './words.ts';

const BARS = { stroke: '#6db7ff', fill: '#6db7ff66' };
const EXACT = { stroke: '#eef1fb', width: 1, dash: [4, 4] };
/** Milliseconds between two pictures: the eye needs no more, and samples may be thousands. */
const INTERVAL = 100;

/** A histogram of a run, with its exact density. */
export class HistogramChart {
  readonly #histogram: LiveHistogram;
  readonly #middles: readonly number[];
  readonly #card: HTMLElement;
  readonly #chart: uPlot;
  #drawnAt = 0;

  /** @param number of the plot @param file name of the file of its numbers, without the ending */
  constructor(parent: HTMLElement, histogram: LiveHistogram, number: number, file: string) {
    const { title, x, exact } = histogram;
    this.#histogram = histogram;
    const count = histogram.densities().length;
    const width = (x.max - x.min) / count;
    this.#middles = Array.from({ length: count }, (_, i) => x.min + (i + 0.5) * width);
    const counted = { label: WORDS.counted, color: BARS.stroke };
    const lines = exact === undefined ? [counted] : [counted, { label: WORDS.exact, color: EXACT.stroke }];
    const save = () => saveText(`${file}.csv`, this.#csv(), 'text/csv');
    this.#card = createChartCard(parent, { title, number, save, names: lineNames(lines) });
    this.#chart = new uPlot(this.#options(), this.#data(), this.#card);
  }

  draw(): void {
    if (this.#chart.root.offsetParent === null || performance.now() - this.#drawnAt < INTERVAL) return;
    this.#drawnAt = performance.now();
    fitChart(this.#chart, this.#card);
    this.#chart.setData(this.#data());
  }

  destroy(): void {
    this.#chart.destroy();
    this.#card.remove();
  }

  #data(): uPlot.AlignedData {
    const { densities, exact } = this.#histogram;
    const middles = [...this.#middles];
    return exact === undefined ? [middles, densities()] : [middles, densities(), middles.map(exact)];
  }

  #csv(): string {
    const columns = this.#data().map((column) => Array.from(column as ArrayLike<number>));
    return csvOf([this.#histogram.x.label, WORDS.density, WORDS.exact].slice(0, columns.length), columns);
  }

  #options(): uPlot.Options {
    const { x, exact } = this.#histogram;
    const bars = { ...BARS, width: 1, points: { show: false }, paths: uPlot.paths.bars?.({ size: [1] }) };
    return {
      ...baseOptions(x.label, WORDS.density),
      cursor: { show: false },
      scales: { x: { time: false, range: () => [x.min, x.max] }, y: { range: (_, __, high) => [0, 1.08 * high || 1] } },
      series: [{}, bars as uPlot.Series, ...(exact === undefined ? [] : [{ ...EXACT, points: { show: false } }])],
    };
  }
}
