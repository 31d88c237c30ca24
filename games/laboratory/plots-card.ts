import type { Example, ExampleRun, LivePlot } from '@principia/scenes/examples';
import type { GameCard } from '@principia/shell';
import uPlot from 'uplot';
import { make } from './make.ts';
import { plainNumber } from './number-text.ts';
import { Samples } from './samples.ts';

const COLORS = ['#ff8f7a', '#6db7ff', '#ffd98a', '#7be0ad', '#c3a6ff'];
const EXACT_COLOR = '#eef1fb';
/** Samples in the duration of an example. */
const SAMPLES = 400;

/** The plots of an example: each is a card of its own. They are made when the first run is known. */
export function createPlotsCard(parent: HTMLElement, { duration }: Example): GameCard<ExampleRun>[] {
  const section = make('div', 'lab-plots');
  parent.append(section);
  const state = { run: undefined as ExampleRun | undefined, charts: [] as Chart[] };
  const follow = (run: ExampleRun) => {
    if (state.run === run) return;
    state.run = run;
    for (const chart of state.charts) chart.destroy();
    state.charts = run.plots.map((plot) => new Chart(section, plot, duration));
  };
  return [
    {
      record(run) {
        follow(run);
        for (const chart of state.charts) chart.record(run.world.time);
      },
      show(run) {
        follow(run);
        for (const chart of state.charts) chart.draw();
      },
    },
  ];
}

/** A plot of a run and its samples. */
class Chart {
  readonly #plot: LivePlot;
  readonly #samples: Samples;
  readonly #card: HTMLElement;
  readonly #chart: uPlot;
  readonly #isOverTime: boolean;
  #isStale = true;

  constructor(parent: HTMLElement, plot: LivePlot, duration: number) {
    this.#plot = plot;
    this.#isOverTime = plot.x.label === 't, s';
    this.#samples = new Samples(plot.series.length + 1, duration / SAMPLES);
    const names = make('span', '');
    names.append(...plot.series.map(({ label }, i) => make('i', '', { style: `--mark: ${colorOf(i)}` }, label)));
    if (plot.series.some(({ exact }) => exact))
      names.append(make('i', '', { style: `--mark: ${EXACT_COLOR}` }, 'exact'));
    this.#card = make('section', 'game-card', { 'aria-label': plot.title }, make('h2', '', {}, plot.title, names));
    parent.append(this.#card);
    this.#chart = new uPlot(chartOptions(plot, this.#isOverTime ? duration : undefined), this.#data(), this.#card);
  }

  record(time: number): void {
    if (this.#samples.discardAfter(time)) this.#isStale = true;
    if (!this.#samples.isDue(time)) return;
    this.#samples.add(time, [this.#plot.x.value(), ...this.#plot.series.map(({ value }) => value())]);
    this.#isStale = true;
  }

  draw(): void {
    if (!this.#isStale || this.#card.offsetParent === null) return;
    this.#isStale = false;
    const width = Math.max(120, this.#card.clientWidth - 24);
    if (width !== this.#chart.width) this.#chart.setSize({ width, height: this.#chart.height });
    this.#chart.setData(this.#data() as uPlot.AlignedData);
  }

  destroy(): void {
    this.#chart.destroy();
    this.#card.remove();
  }

  /** Series with an exact value are followed by it. */
  #data(): uPlot.AlignedData {
    const [times, x, ...values] = this.#samples.columns;
    const lines = this.#plot.series.flatMap(({ exact }, i) =>
      exact === undefined ? [values[i]] : [values[i], times.map((time) => exact(time))],
    );
    return [x, ...lines] as uPlot.AlignedData;
  }
}

const colorOf = (index: number) => COLORS[index % COLORS.length];

function chartOptions({ x, y, series }: LivePlot, duration: number | undefined): uPlot.Options {
  const grid = { stroke: '#ffffff14', width: 1 };
  const font = '11px system-ui, sans-serif';
  const axis = { stroke: '#97a3c7', grid, ticks: { show: false }, font, labelFont: font, labelSize: 14 };
  const values = (_: uPlot, splits: number[]) => splits.map(plainNumber);
  const lines = series.flatMap(({ label, exact }, i): uPlot.Series[] => {
    const line = { label, stroke: colorOf(i), width: 1.6, points: { show: false } };
    const known = { label: 'exact', stroke: EXACT_COLOR, width: 1, dash: [4, 4], points: { show: false } };
    return exact === undefined ? [line] : [line, known];
  });
  return {
    // A path against another quantity than the time is not sorted by it.
    mode: 1,
    width: 240,
    height: 150,
    padding: [6, 6, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    scales: {
      x: { time: false, ...(duration === undefined ? {} : { range: (_, __, high) => [0, Math.max(duration, high)] }) },
    },
    axes: [
      { ...axis, size: 22, values, space: 50, label: x.label },
      { ...axis, size: 46, values, space: 24, label: y.label },
    ],
    series: [{}, ...lines],
  };
}
