import type { CheckState, Example, ExampleRun, Tolerance } from '@principia/scenes/examples';
import { element, type GameCard } from '@principia/shell';
import { integratorName } from './integrator-names.ts';
import { percentage, plainNumber } from './number-text.ts';
import { isDisturbed } from './on-display.ts';
import { WORDS } from './words.ts';

const MARKS = { waiting: '…', passed: '✓', failed: '✗', 'not applicable': '–', 'no figure': '–' } as const;

/** The figures that prove the example right, as they are measured in the run on display. */
export function createChecksCard(parent: HTMLElement, { checks }: Example): GameCard<ExampleRun> {
  const rows = checks.map(({ label, unit = '', tolerance, integrator, preset }) => {
    const mark = element('b', '', { 'aria-hidden': 'true' });
    const text = element('p', '');
    const about = integrator === undefined ? label : `${label} (${integratorName(integrator.name)})`;
    const row = element('li', '', {}, mark, element('div', '', {}, element('h3', '', { lang: 'en' }, about), text));
    return {
      mark,
      text,
      row,
      shown: '',
      unit: unit === '' ? '' : ` ${unit}`,
      tolerance,
      needs: integrator && integratorName(integrator.name),
      preset,
    };
  });
  const list = element('ul', 'lab-checks', { 'aria-live': 'polite' });
  list.append(...rows.map(({ row }) => row));
  parent.append(
    element('section', 'game-card', { 'aria-label': WORDS.checks }, element('h2', '', {}, WORDS.checksHeading), list),
  );
  return {
    show(run) {
      run.observe();
      const states = run.checkStates().map((state) => (isDisturbed(run) ? unjudged(state) : state));
      for (const [i, state] of states.entries()) {
        const line = rows[i];
        const text = isDisturbed(run)
          ? takenPart(state, line.unit)
          : sentence(state, line.unit, line.tolerance, line.needs);
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

/** What is failed or waiting proves nothing about a run in which the reader took part. */
function unjudged(state: CheckState): CheckState {
  return state.state === 'passed' || state.state === 'no figure' ? state : { ...state, state: 'not applicable' };
}

function takenPart({ state, computed, exact }: CheckState, unit: string): string {
  if (state === 'no figure') return WORDS.noFigure;
  const measured = Number.isFinite(computed) ? WORDS.computed(`${plainNumber(computed)}${unit}`) : '';
  return `${measured}${WORDS.leftAlone(`${plainNumber(exact)}${unit}`)}`;
}

function sentence(
  { state, computed, exact, error }: CheckState,
  unit: string,
  tolerance: Tolerance,
  needs?: string,
): string {
  if (state === 'no figure') return WORDS.noFigure;
  if (state === 'not applicable') {
    return needs === undefined ? WORDS.default : WORDS.defaultWith(needs);
  }
  if (state === 'waiting') return WORDS.waiting(`${plainNumber(exact)}${unit}`);
  const off = 'relative' in tolerance ? percentage(error) : `${plainNumber(error)}${unit}`;
  return WORDS.measured(plainNumber(computed), `${plainNumber(exact)}${unit}`, off);
}
