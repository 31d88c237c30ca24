import { EXAMPLES, type Example, type ExampleRun } from '@principia/scenes/examples';
import type { GameCard } from '@principia/shell';
import { make } from './make.ts';

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
  const heading = make('h2', '', {}, `Chapter ${example.chapter}`);
  const card = make('section', 'game-card lab-about', { 'aria-label': 'About' }, heading, about);
  card.append(make('h2', '', {}, 'Try this'), tries, neighbours);
  parent.prepend(card);
  return { show() {} };
}
