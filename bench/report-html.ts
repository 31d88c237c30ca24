// The report of a run as a single HTML file without scripts, fonts or external images.
import type { Scene } from '@principia/scenes';
import { barsChart, escapeHtml, histogramChart, stackChart, traceChart } from './report-charts.ts';
import { REPORT_STYLE } from './report-style.ts';
import { mega, ms } from './report-table.ts';
import type { Result } from './result.ts';
import type { Outcome } from './run-bench.ts';
import { growthOf } from './scaling.ts';
import { scalingChart } from './scaling-chart.ts';

export function reportHtml({ result, series }: Outcome, scene: Scene): string {
  const { scene: name, count, dimensions, precision } = result;
  const title = `${name}: ${count.toLocaleString('en')} in ${dimensions}D, ${precision}`;
  const sections = [
    section(
      'Step time',
      `Every timed step in order; ${result.warmup} warm-up steps came before.`,
      traceChart(series, result.warmup),
    ),
    section('Distribution', 'How many steps took how long.', histogramChart(series)),
    section(
      'Phases',
      'Where a step spends its time, the mean of further steps with the clock on.',
      stackChart(result.profile),
    ),
    peersSection(result),
    scalingSection(result),
    creationSection(result),
    section('Parameters', escapeHtml(scene.description), parametersTable(result, scene)),
    section('Run', '', runTable(result)),
  ];
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escapeHtml(title)}</title>
<link rel="icon" href="data:,">
<style>${REPORT_STYLE}</style>
</head>
<body>
<main>
<h1>${escapeHtml(title)}</h1>
${tiles(result)}
${sections.join('\n')}
</main>
</body>
</html>
`;
}

function tiles({ msPerStep, nsPerBodyStep, create, garbageBytesPerStep }: Result): string {
  const facts: [string, string][] = [
    ['median step', ms(msPerStep.median)],
    ['per body and step', `${nsPerBodyStep.toFixed(2)} ns`],
    ['99 % of steps under', ms(msPerStep.p99)],
    ['creation', ms(create.ms)],
    ['memory', mega(create.bytes)],
    ['garbage a step', `${garbageBytesPerStep} bytes`],
  ];
  const tile = ([label, value]: [string, string]) => `<div class="tile"><span>${label}</span><b>${value}</b></div>`;
  return `<div class="tiles">${facts.map(tile).join('')}</div>`;
}

function section(heading: string, about: string, content: string): string {
  return `<section><h2>${heading}</h2>${about === '' ? '' : `<p>${about}</p>`}${content}</section>`;
}

function peersSection({ peers, msPerStep }: Result): string {
  if (peers.length === 0) return '';
  const rows = [
    { name: 'this framework', value: msPerStep.median, note: ms(msPerStep.median) },
    ...peers.map(({ name, msPerStep: time, ratio }) => ({
      name,
      value: time,
      note: `${ms(time)}, ${ratio.toFixed(2)}x our time`,
    })),
  ];
  const about = 'Median step of others doing the same work, measured step by step in turn with ours in one process.';
  return section('Beside us', about, barsChart(rows));
}

function scalingSection({ scene, scaling }: Result): string {
  if (scaling.length === 0) return '';
  const about = `The median of a few steps at other counts. It grows as N^${growthOf(scaling).toFixed(2)}.`;
  return section('Cost by count', about, scalingChart([{ name: scene, points: scaling }]));
}

function creationSection({ create, count }: Result): string {
  if (create.peers.length === 0) return '';
  const rows = [{ name: 'this framework', ms: create.ms, bytes: create.bytes }, ...create.peers].map((row) => ({
    name: row.name,
    value: row.ms,
    note: `${ms(row.ms)}, ${mega(row.bytes)}, ${(row.bytes / count).toFixed(0)} bytes each`,
  }));
  const about = 'Making the world; bare bitECS makes as many entities with one component each and stores no values.';
  return section('Creation', about, barsChart(rows));
}

function parametersTable(result: Result, scene: Scene): string {
  const rows = Object.entries(scene.parameters).map(([name, { about, unit, initial }]) => {
    const value = name === 'count' ? result.count : initial;
    return [name, `${value.toLocaleString('en', { maximumSignificantDigits: 6 })} ${unit}`.trim(), about] as const;
  });
  return table(rows);
}

function runTable(result: Result): string {
  const { machine, energyDrift, energyNote, rmsForceError } = result;
  const error: [string, string, string][] =
    rmsForceError === null ? [] : [['force error', rmsForceError.toExponential(2), 'RMS, relative to the direct sum']];
  return table([
    ['steps', `${result.steps}`, `${result.warmup} of them warm-up`],
    ['seed', `${result.seed}`, ''],
    ['state hash', result.hash, 'of the state after all steps; equal on every machine'],
    ['energy drift', energyDrift === null ? 'no energy' : energyDrift.toExponential(2), energyNote ?? ''],
    ...error,
    ['date', result.date.slice(0, 16).replace('T', ' '), 'UTC'],
    ['machine', `Node ${machine.node}`, `${machine.cpu}, ${machine.cores} cores, ${machine.platform}`],
  ]);
}

function table(rows: readonly (readonly [string, string, string])[]): string {
  const cells = rows.map((row) => `<tr>${row.map((cell) => `<td>${escapeHtml(cell)}</td>`).join('')}</tr>`);
  return `<table>${cells.join('')}</table>`;
}
