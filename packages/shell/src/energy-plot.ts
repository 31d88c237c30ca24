import { energy, type PhysicsWorld } from '@principia/physics';
import uPlot from 'uplot';
import { element } from './element.ts';
import { EnergyHistory } from './energy-history.ts';
import { joules } from './joules.ts';

/** A plot of the world's energies over the last seconds. */
export interface EnergyPlot {
  /** Notes the world's energies, if the last note is old enough; call it after the steps of a frame. */
  note(world: PhysicsWorld): void;
  /** Draws what was noted. */
  draw(): void;
  clear(): void;
  toggle(): void;
}

const SAMPLES = 240;
const INTERVAL = 0.05;
const SERIES = [
  ['kinetic', '#ff8f7a'],
  ['potential', '#6db7ff'],
  ['total', '#ffd98a'],
] as const;

export function createEnergyPlot(parent: HTMLElement): EnergyPlot {
  const history = new EnergyHistory(SAMPLES, INTERVAL);
  const names = element('span', '');
  for (const [name, color] of SERIES) names.append(element('i', '', { style: `--mark: ${color}` }, name));
  const card = element('section', 'game-card', { 'aria-label': 'Energy' }, element('h2', '', {}, 'Energy', names));
  parent.append(card);
  const plot = new uPlot(plotOptions(), history.data(), card);
  let stale = false;
  return {
    note(world) {
      if (card.hidden || !history.isDue(world.time)) return;
      history.add(world.time, energy(world));
      stale = true;
    },
    draw() {
      if (!stale || card.hidden || card.offsetParent === null) return;
      stale = false;
      plot.setData(history.data());
    },
    clear() {
      history.clear();
      stale = true;
    },
    toggle() {
      card.hidden = !card.hidden;
      history.clear();
      stale = true;
    },
  };
}

function plotOptions(): uPlot.Options {
  const grid = { stroke: '#ffffff14', width: 1 };
  const ticks = { show: false };
  const font = '11px system-ui, sans-serif';
  const axis = { stroke: '#97a3c7', grid, ticks, font };
  return {
    width: 240,
    height: 118,
    padding: [6, 4, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    scales: {
      x: { time: false, range: (_, low, high) => [Math.min(low, high - SAMPLES * INTERVAL), Math.max(high, low + 1)] },
      y: { range: (_, low, high) => [Math.min(0, low), high > 0 ? high * 1.08 : 1] },
    },
    axes: [
      {
        ...axis,
        size: 20,
        values: (_, splits) => splits.map((second) => (second < 0 ? '' : `${second} s`)),
        space: 60,
      },
      { ...axis, size: 46, values: (_, splits) => splits.map(joules), space: 28 },
    ],
    series: [{}, ...SERIES.map(([label, stroke]) => ({ label, stroke, width: 1.5, points: { show: false } }))],
  };
}
