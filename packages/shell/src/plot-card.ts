import type { PhysicsWorld } from '@principia/physics';
import uPlot from 'uplot';
import { element } from './element.ts';
import {
  angularMomentumSource,
  type ColumnName,
  columnSource,
  columnsInUse,
  energySource,
  inUnits,
  momentumSource,
  type OwnUnits,
  type PlotSource,
} from './plot-sources.ts';
import { SAFE_COLORS } from './preferences.ts';
import { SeriesHistory } from './series-history.ts';
import { siNumber } from './si-number.ts';
import { drawTimeMark } from './time-mark.ts';
import { words } from './words.ts';

/** A plot over the last seconds: energies, momenta, or any column. */
export interface PlotCard {
  /**
   * Records the world's values if the last sample is old enough; call it after the steps of a frame.
   * @param isPast the world stands at a recorded moment: samples are kept, and a line marks its time
   */
  record(world: PhysicsWorld, isPast?: boolean): void;
  /** Draws the recorded samples. */
  draw(): void;
  /** Discards the samples because the world was replaced. */
  clear(): void;
  /** Shows the next plot; hides the card after the last one. */
  next(): void;
  /** Whether lines use the colour-blind palette. */
  safeColors: boolean;
}

const SAMPLES = 240;
const INTERVAL = 0.05;
const COLORS = ['#ff8f7a', '#6db7ff', '#ffd98a'];
const SAFE = [5, 1, 3].map((index) => `#${SAFE_COLORS[index].toString(16).padStart(6, '0')}`);
const PLOTS = ['Energy', 'Momentum', 'Angular momentum', 'Any value'] as const;

/** @param world returns the world on display @param units of a world that is not in SI */
export function createPlotCard(
  parent: HTMLElement,
  world: () => PhysicsWorld | undefined,
  units: OwnUnits = {},
): PlotCard {
  const { choice, column, body, which, names, card } = createElements(parent);
  const state = { safe: false, source: energySource as PlotSource, stale: false, shown: '', mark: Number.NaN };
  let history = new SeriesHistory(3, SAMPLES, INTERVAL);
  let values = new Float64Array(3);
  let plot: uPlot | undefined;
  /** Applies the choices of the controls from now on. */
  const show = () => {
    const before = state.shown;
    which.hidden = choice.value !== 'Any value';
    if (!which.hidden) fillColumns(column, world());
    state.source = inUnits(sourceOf(choice.value, column.value, Number(body.value), world()), units);
    const { series } = state.source;
    state.shown = [state.safe, state.source.unit, ...series].join();
    state.stale = true;
    // A similar world keeps the plot object, because clearing it costs less than creating it.
    if (state.shown === before) {
      history.clear();
      return;
    }
    history = new SeriesHistory(series.length, SAMPLES, INTERVAL);
    values = new Float64Array(series.length);
    const colors = state.safe ? SAFE : COLORS;
    names.replaceChildren(...lineNames(state.source, colors));
    plot?.destroy();
    plot = new uPlot(
      plotOptions(state.source, colors, () => state.mark),
      history.data(),
      card,
    );
  };
  for (const control of [choice, column, body]) control.addEventListener('change', show);
  show();
  return {
    get safeColors() {
      return state.safe;
    },
    set safeColors(safe) {
      state.safe = safe;
      show();
    },
    record(now, isPast = false) {
      const mark = isPast ? now.time : Number.NaN;
      if (!Object.is(mark, state.mark)) state.stale = true;
      state.mark = mark;
      if (isPast) return;
      if (history.discardAfter(now.time)) state.stale = true;
      if (card.hidden || !history.isDue(now.time)) return;
      state.source.read(now, values);
      history.add(now.time, values);
      state.stale = true;
    },
    draw() {
      if (!state.stale || card.hidden || card.offsetParent === null) return;
      state.stale = false;
      plot?.setData(history.data());
    },
    clear: show,
    next() {
      const at = card.hidden ? 0 : choice.selectedIndex + 1;
      card.hidden = at === PLOTS.length;
      choice.selectedIndex = at % PLOTS.length;
      show();
    },
  };
}

function createElements(parent: HTMLElement) {
  const { plots, plot: plotLabel, value, body: bodyLabel, bodyTitle, bodyHint } = words();
  const choice = select(
    plotLabel,
    PLOTS.map((name) => [name, plots[name]] as const),
  );
  const column = select(value, []);
  const body = element('input', '', { type: 'number', min: '0', step: '1', value: '0', 'aria-label': bodyTitle });
  const which = element(
    'div',
    'game-plot-column',
    {},
    column,
    element('label', '', { title: bodyHint }, `${bodyLabel} `, body),
  );
  const names = element('span', '');
  const card = element(
    'section',
    'game-card',
    { 'aria-label': plotLabel },
    element('h2', '', {}, choice, names),
    which,
  );
  parent.append(card);
  return { choice, column, body, which, names, card };
}

/** @param options pairs of value and label */
function select(label: string, options: readonly (readonly [string, string])[]): HTMLSelectElement {
  const made = element('select', '', { 'aria-label': label });
  for (const [value, shown] of options) made.append(element('option', '', { value }, shown));
  return made;
}

/** Offers the columns that have non-zero values, and keeps the selection. */
function fillColumns(list: HTMLSelectElement, world: PhysicsWorld | undefined): void {
  if (world === undefined) return;
  const chosen = list.value;
  const names = columnsInUse(world).map(({ component, field }) => `${component}.${field}`);
  if (chosen !== '' && !names.includes(chosen)) names.push(chosen);
  list.replaceChildren(...names.map((name) => element('option', '', {}, name)));
  list.value = names.includes(chosen) ? chosen : (names[0] ?? '');
}

function sourceOf(plot: string, column: string, body: number, world: PhysicsWorld | undefined): PlotSource {
  const dimensions = world?.dimensions ?? 2;
  if (plot === 'Momentum') return momentumSource(dimensions);
  if (plot === 'Angular momentum') return angularMomentumSource(dimensions);
  if (plot !== 'Any value' || column === '') return energySource;
  const [component, field] = column.split('.');
  const name = { component, field } as ColumnName;
  return columnSource(name, Number.isInteger(body) && body > 0 ? body : 0);
}

/** A unit of one word fits beside the numbers; longer ones stand above. */
const isCompound = (unit: string): boolean => /[ /]/.test(unit);

/** The names of the lines in their colours, and a unit that is too long for the axis. */
function lineNames({ series, unit }: PlotSource, colors: readonly string[]): HTMLElement[] {
  const lines = series.map((name, i) =>
    element('i', '', { style: `--mark: ${colors[i]}` }, words().names[name] ?? name),
  );
  return isCompound(unit) ? [...lines, element('small', '', {}, unit)] : lines;
}

/** @param mark the time where a line is drawn, s, or not a number */
function plotOptions({ series, unit }: PlotSource, colors: readonly string[], mark: () => number): uPlot.Options {
  const grid = { stroke: '#ffffff14', width: 1 };
  const axis = { stroke: '#97a3c7', grid, ticks: { show: false }, font: '11px system-ui, sans-serif' };
  const shown = isCompound(unit) ? '' : unit;
  return {
    width: 240,
    height: 118,
    padding: [6, 4, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    hooks: { draw: [(chart) => drawTimeMark(chart, mark())] },
    scales: {
      x: { time: false, range: (_, low, high) => [Math.min(low, high - SAMPLES * INTERVAL), Math.max(high, low + 1)] },
      y: { range: (_, low, high) => rangeOf(low, high) },
    },
    axes: [
      {
        ...axis,
        size: 20,
        values: (_, splits) => splits.map((second) => (second < 0 ? '' : `${second} s`)),
        space: 60,
      },
      { ...axis, size: 46, values: (_, splits) => splits.map((value) => siNumber(value, shown)), space: 28 },
    ],
    series: [
      {},
      ...series.map((label, i) => ({ label, stroke: colors[i], width: 1.5, points: { show: false }, spanGaps: false })),
    ],
  };
}

/** The range includes zero, with a margin on either side. */
function rangeOf(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null || !Number.isFinite(low + high)) return [0, 1];
  const [bottom, top] = [Math.min(0, low), Math.max(0, high)];
  return bottom === top ? [0, 1] : [bottom * 1.08, top * 1.08];
}
