import type { Example } from '@principia/scenes/examples';
import { element, type GameCard } from '@principia/shell';
import { Chart } from './chart.ts';
import { HistogramChart } from './histogram-chart.ts';
import type { LabRun } from './lab-run.ts';

/** The plots of an example: each is a card of its own. They are made anew for each run. */
export function createPlotsCard(parent: HTMLElement, { id, duration }: Example): GameCard<LabRun>[] {
  const section = element('div', 'lab-plots');
  parent.append(section);
  const state = { run: undefined as LabRun | undefined, charts: [] as Chart[], histograms: [] as HistogramChart[] };
  const follow = (run: LabRun) => {
    if (state.run === run) return;
    state.run = run;
    for (const chart of [...state.charts, ...state.histograms]) chart.destroy();
    state.charts = run.plots.map((_, i) => new Chart(section, run, i, { duration, file: `${id}-${i + 1}` }));
    state.histograms = run.histograms.map(
      (histogram, i) => new HistogramChart(section, histogram, run.plots.length + i + 1, `${id}-histogram-${i + 1}`),
    );
  };
  return [
    {
      record(run, isPast) {
        follow(run);
        for (const chart of state.charts) chart.record(isPast);
      },
      show(run) {
        follow(run);
        for (const chart of [...state.charts, ...state.histograms]) chart.draw();
      },
    },
  ];
}
