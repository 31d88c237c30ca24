/** The card of a chart: a title that folds it up, its buttons, and the names of its lines. */
import { element } from '@principia/shell';
import { SHOWN_PLOTS } from './shown-plots.ts';
import { WORDS } from './words.ts';

export interface ChartCardOptions {
  readonly title: string;
  /** Number of the plot among those of the example. */
  readonly number: number;
  /** Hands the numbers to the reader. */
  readonly save: () => void;
  /** What stands between the title and the button that saves. */
  readonly more?: readonly HTMLElement[];
  /** Names of the lines. */
  readonly names: HTMLElement;
}

/** @returns the card, which a chart is appended to */
export function createChartCard(parent: HTMLElement, options: ChartCardOptions): HTMLElement {
  const { title, number, save, more = [], names } = options;
  const { folded } = SHOWN_PLOTS;
  const fold = element('button', 'lab-fold', { type: 'button', lang: 'en' }, title);
  const csv = element('button', 'lab-save', { type: 'button', title: WORDS.save }, 'CSV');
  csv.addEventListener('click', save);
  const heading = element('h2', '', {}, fold, ...more, csv, names);
  const card = element('section', 'game-card lab-plot', { 'aria-label': title }, heading);
  const show = () => {
    card.toggleAttribute('data-folded', folded.has(number));
    fold.setAttribute('aria-expanded', String(!folded.has(number)));
  };
  fold.addEventListener('click', () => {
    if (!folded.delete(number)) folded.add(number);
    show();
  });
  show();
  parent.append(card);
  return card;
}

/** The names of lines, in their colours. */
export function lineNames(
  lines: readonly { readonly label: string; readonly color: string; readonly lang?: object }[],
): HTMLElement {
  const names = element('span', '');
  names.append(
    ...lines.map(({ label, color, lang }) => element('i', '', { style: `--mark: ${color}`, ...lang }, label)),
  );
  return names;
}
