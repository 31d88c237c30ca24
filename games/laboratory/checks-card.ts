import type { CheckState, Example, ExampleRun, Tolerance } from '@principia/scenes/examples';
import type { GameCard } from '@principia/shell';
import { make } from './make.ts';
import { percentage, plainNumber } from './number-text.ts';

const MARKS = { waiting: '…', passed: '✓', failed: '✗', 'not applicable': '–' } as const;

/** The figures that prove the example right, as they are measured in the run on display. */
export function createChecksCard(parent: HTMLElement, { checks }: Example): GameCard<ExampleRun> {
  const rows = checks.map(({ label, unit, tolerance, integrator, preset }) => {
    const mark = make('b', '', { 'aria-hidden': 'true' });
    const text = make('p', '');
    const about = integrator === undefined ? label : `${label} (${integrator.name})`;
    const row = make('li', '', {}, mark, make('div', '', {}, make('h3', '', {}, about), text));
    return {
      mark,
      text,
      row,
      shown: '',
      unit: unit === '' ? '' : ` ${unit}`,
      tolerance,
      needs: integrator?.name,
      preset,
    };
  });
  const list = make('ul', 'lab-checks', { 'aria-live': 'polite' });
  list.append(...rows.map(({ row }) => row));
  parent.append(
    make('section', 'game-card', { 'aria-label': 'Checks' }, make('h2', '', {}, 'Computed and exact'), list),
  );
  return {
    show(run) {
      run.observe();
      for (const [i, state] of run.checkStates().entries()) {
        const line = rows[i];
        const text = sentence(state, line.unit, line.tolerance, line.needs);
        if (line.shown === text) continue;
        line.shown = text;
        line.text.textContent = text;
        line.mark.textContent = MARKS[state.state];
        line.row.dataset.state = state.state;
        // A figure of a preset is shown with its values only.
        line.row.hidden = line.preset !== undefined && state.state === 'not applicable';
      }
    },
  };
}

function sentence(
  { state, computed, exact, error }: CheckState,
  unit: string,
  tolerance: Tolerance,
  needs?: string,
): string {
  if (state === 'not applicable') {
    return needs === undefined ? 'holds for the default settings' : `holds for the default settings and ${needs}`;
  }
  if (state === 'waiting') return `waiting; exact ${plainNumber(exact)}${unit}`;
  const off = 'relative' in tolerance ? percentage(error) : `${plainNumber(error)}${unit}`;
  return `computed ${plainNumber(computed)}, exact ${plainNumber(exact)}${unit}, error ${off}`;
}
