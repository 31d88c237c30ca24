import { EXAMPLES, type Example, type ExampleRun } from '@principia/scenes/examples';
import type { GameCard } from '@principia/shell';
import { make } from './make.ts';
import { momentAddress } from './moment.ts';

/** What the example is about, what to try, and the ways to its neighbours; it stands above the settings. */
export function createAboutCard(parent: HTMLElement, example: Example): GameCard<ExampleRun> {
  const at = EXAMPLES.findIndex(({ id }) => id === example.id);
  const neighbours = make('nav', 'lab-neighbours', { 'aria-label': 'Other examples' });
  for (const [entry, label] of [
    [EXAMPLES[at - 1], '‹'],
    [EXAMPLES[at + 1], '›'],
  ] as const) {
    if (entry !== undefined) {
      neighbours.append(make('a', '', { href: `?example=${entry.id}`, title: entry.title }, `${label} ${entry.title}`));
    }
  }
  const tries = make('ul', '');
  tries.append(...example.tryThis.map((sentence) => make('li', '', {}, sentence)));
  const about = make('p', '', {}, example.about);
  const heading = make('h2', '', {}, `Chapter ${example.chapter} · ${example.title}`);
  const card = make('section', 'game-card lab-about', { 'aria-label': 'About' }, heading, about);
  card.append(make('h2', '', {}, 'Try this'), tries, buttonsOf(example), neighbours);
  parent.prepend(card);
  return { show() {} };
}

/** Presets, and the address of the present moment. */
function buttonsOf({ id, presets }: Example): HTMLElement {
  const row = make('div', 'lab-presets');
  for (const { label, values } of presets) {
    const query = new URLSearchParams({ example: id });
    for (const [name, value] of Object.entries(values)) query.set(name, String(value));
    row.append(make('a', '', { href: `?${query}` }, label));
  }
  const copy = make(
    'button',
    '',
    { type: 'button', title: 'Copy the address of this step and this view' },
    'Copy link',
  );
  copy.addEventListener('click', async () => {
    await navigator.clipboard.writeText(momentAddress());
    copy.textContent = 'Copied';
    setTimeout(() => {
      copy.textContent = 'Copy link';
    }, 2000);
  });
  row.append(copy);
  return row;
}
