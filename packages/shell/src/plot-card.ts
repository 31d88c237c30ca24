import { bodies, type PhysicsWorld } from '@principia/physics';
import uPlot from 'uplot';
import { csvOf, saveText } from './csv.ts';
import type { Simulation } from './game.ts';
import { NO_PLOT, readPlotChoice, writePlotChoice } from './plot-choice.ts';
import { PlotControls } from './plot-controls.ts';
import { pathOptions, plotData, timeOptions } from './plot-options.ts';
import {
  inUnits,
  type OwnQuantities,
  type OwnUnits,
  type PlotSource,
  pathChoice,
  phaseChoice,
} from './plot-sources.ts';
import { SAFE_COLORS } from './preferences.ts';
import { Sampling } from './sampling.ts';
import { SeriesHistory } from './series-history.ts';
import { words } from './words.ts';

const COLORS = ['#ff8f7a', '#6db7ff', '#ffd98a'];
const SAFE = [5, 1, 3].map((index) => `#${SAFE_COLORS[index].toString(16).padStart(6, '0')}`);

/** What a plot shows beside the quantities of every world. */
export interface PlotCardOptions {
  /** Units of a world that is not in SI. */
  readonly units?: OwnUnits | undefined;
  /** Quantities of the game's own. */
  readonly own?: OwnQuantities;
  /** Time between two rows that the game asks for, s. */
  readonly interval?: () => number | undefined;
}

/** A plot of the last seconds: energies, momenta, or any column, over time or against any other quantity. */
export class PlotCard {
  readonly #sim: () => Simulation | undefined;
  readonly #interval: () => number | undefined;
  readonly #units: OwnUnits;
  readonly #own: OwnQuantities;
  readonly #controls: PlotControls;
  #safe = false;
  #source!: PlotSource;
  /** The quantity along the horizontal axis, if it is not the time. */
  #against: PlotSource | undefined;
  #history!: SeriesHistory;
  #sampling!: Sampling;
  /** The step at which the world was looked at last; none after it was moved to a recorded moment. */
  #tick = -1;
  /** The values of a row: of the lines, then along the horizontal axis. */
  #values = new Float64Array(0);
  #x = new Float64Array(0);
  #plot: uPlot | undefined;
  #isStale = false;
  /** What the plot was made for. */
  #shown = '';
  /** No plot is shown before there is a body, unless the reader asks for one. */
  #isWaiting = false;
  /** Time of the recorded moment that is shown, s; not a number while none is. */
  #mark = Number.NaN;

  /** @param sim returns what is on display */
  constructor(parent: HTMLElement, sim: () => Simulation | undefined, options: PlotCardOptions = {}) {
    const { units = {}, own = {}, interval = () => undefined } = options;
    this.#sim = sim;
    this.#interval = interval;
    this.#units = units;
    this.#own = own;
    this.#controls = new PlotControls(
      parent,
      own,
      () => this.#show(),
      (kind) => this.#choosePath(kind),
      () => saveText('plot.csv', this.#csv(), 'text/csv'),
    );
    const first = this.#world();
    this.#isWaiting = first !== undefined && bodies(first).count === 0;
    if (this.#isWaiting) this.#controls.card.hidden = true;
    this.#show();
  }

  #world(): PhysicsWorld | undefined {
    return this.#sim()?.world;
  }

  /** Whether lines use the colour-blind palette. */
  get safeColors(): boolean {
    return this.#safe;
  }

  set safeColors(safe: boolean) {
    this.#safe = safe;
    this.#show();
  }

  /**
   * Records the world's values unless this step has a row already; call it after each step, and in every frame.
   * @param isPast the world stands at a recorded moment: rows are kept, and a line or a dot marks its time
   */
  record(world: PhysicsWorld, isPast = false): void {
    const mark = isPast ? world.time : Number.NaN;
    if (!Object.is(mark, this.#mark)) this.#isStale = true;
    this.#mark = mark;
    if (isPast) this.#tick = -1;
    if (isPast) return;
    if (this.#isWaiting && bodies(world).count > 0) this.#reveal();
    if (world.tick === this.#tick) return;
    this.#tick = world.tick;
    // After the world was moved back and stepped on, these are of another future.
    if (this.#history.discardFrom(world.tick)) this.#isStale = true;
    if (this.#controls.card.hidden || world.tick % this.#sampling.stride !== 0) return;
    const start = performance.now();
    this.#source.read(world, this.#values);
    if (this.#against !== undefined) {
      this.#against.read(world, this.#x);
      this.#values[this.#values.length - 1] = this.#x[0];
    }
    this.#history.add(world.tick, world.time, this.#values);
    this.#isStale = true;
    if (this.#sampling.spent(performance.now() - start)) this.#thin();
  }

  /** There are fewer rows from now on. */
  #thin(): void {
    const { stride, rows, interval } = this.#sampling;
    this.#history.thin(stride, rows);
    this.#controls.showInterval(stride > 1 ? interval : 0);
  }

  #reveal(): void {
    this.#isWaiting = false;
    this.#controls.card.hidden = false;
    this.#show();
  }

  /** Draws the rows. Of those that share a pixel uPlot draws the least and the largest: a fast oscillation is a band. */
  draw(): void {
    const { card } = this.#controls;
    if (!this.#isStale || card.hidden || card.offsetParent === null) return;
    this.#isStale = false;
    this.#plot?.setData(plotData(this.#history, this.#against !== undefined));
  }

  destroy(): void {
    this.#plot?.destroy();
  }

  /** Discards the rows because the world was replaced. */
  clear(): void {
    this.#show();
  }

  /** What is shown, as the address names it. */
  get choice(): string {
    const { card, choice } = this.#controls;
    return card.hidden && !this.#isWaiting ? NO_PLOT : writePlotChoice(choice);
  }

  /** Shows what the address names. @returns a sentence if it names no plot, which then stays as it is */
  choose(text: string): string {
    const isHidden = text === NO_PLOT;
    const choice = isHidden ? this.#controls.choice : readPlotChoice(text, this.#world()?.dimensions ?? 2, this.#own);
    if (choice === undefined) return words().address.plot(text);
    this.#isWaiting = false;
    this.#controls.card.hidden = isHidden;
    this.#controls.choice = choice;
    this.#show();
    return '';
  }

  /** Shows the next plot; hides the card after the last one. */
  next(): void {
    this.#isWaiting = false;
    this.#controls.next();
    this.#show();
  }

  #choosePath(kind: 'path' | 'phase'): void {
    const world = this.#world();
    if (world === undefined) return;
    this.#controls.choose((kind === 'path' ? pathChoice : phaseChoice)(world, this.#controls.body));
    this.#show();
  }

  /** Applies the choices of the controls from now on. */
  #show(): void {
    const { source, against } = this.#controls.read(this.#world());
    this.#source = inUnits(source, this.#units);
    this.#against = against && inUnits(against, this.#units);
    const before = this.#shown;
    const { series, unit } = this.#source;
    const dt = this.#sim()?.dt ?? 1 / 60;
    this.#sampling = new Sampling(dt, this.#against === undefined ? 'time' : 'path', this.#interval());
    const { stride, rows, interval } = this.#sampling;
    const made = [this.#safe, rows, unit, ...series, this.#against?.unit, ...(this.#against?.series ?? [])];
    this.#shown = made.join();
    this.#tick = -1;
    this.#isStale = true;
    this.#controls.showInterval(stride > 1 ? interval : 0);
    // A similar world keeps the plot object, because clearing it costs less than creating it.
    if (this.#shown === before) this.#history.clear();
    else this.#make();
  }

  #make(): void {
    const isPath = this.#against !== undefined;
    const count = this.#source.series.length + (isPath ? 1 : 0);
    this.#history = new SeriesHistory(count, this.#sampling.rows);
    this.#values = new Float64Array(count);
    this.#x = new Float64Array(1);
    const colors = this.#safe ? SAFE : COLORS;
    this.#controls.showNames(this.#source, this.#against, colors);
    this.#plot?.destroy();
    const mark = () => this.#mark;
    const options =
      this.#against === undefined
        ? timeOptions(this.#source, colors, mark)
        : pathOptions(this.#source, this.#against, colors, this.#history, mark);
    this.#plot = new uPlot(options, plotData(this.#history, isPath), this.#controls.card);
  }

  /** The rows with their times; the horizontal axis is the last column. */
  #csv(): string {
    const { chosen } = this.#controls;
    const unitOf = ({ unit }: PlotSource) => (unit === '' ? '' : `, ${unit}`);
    const names = this.#source.series.map(
      (name) => `${`${chosen} ${words().names[name] ?? name}`.trim()}${unitOf(this.#source)}`,
    );
    const x = this.#against === undefined ? [] : [`${this.#against.series[0]}${unitOf(this.#against)}`];
    return csvOf(['t, s', ...names, ...x], this.#history.data());
  }
}
