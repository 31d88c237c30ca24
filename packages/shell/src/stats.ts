import { element } from './element.ts';
import { decimal, grouped } from './language.ts';
import type { Statistics } from './statistics.ts';
import { words } from './words.ts';

/** A small table of statistics. */
export interface Stats {
  show(statistics: Statistics): void;
}

const milliseconds = (value: number) => `${decimal(value, value < 9.95 ? (value < 0.995 ? 2 : 1) : 0)} ms`;

export function createStats(parent: HTMLElement): Stats {
  const list = element('dl', 'game-stats');
  const rows = words().stats.map((label) => {
    const row = [element('dt', '', {}, label), element('dd', '', {}, '–')] as const;
    list.append(...row);
    return row;
  });
  parent.append(element('section', 'game-card', { 'aria-label': words().statistics }, list));
  return {
    show({ frame, step, draw, bodies, contacts, time }) {
      // Texts are not made while the table is hidden.
      if (list.offsetParent === null) return;
      const texts = [milliseconds(frame), grouped(bodies), milliseconds(step)];
      texts.push(contacts === undefined ? '' : grouped(contacts), milliseconds(draw), `${decimal(time, 1)} s`);
      for (const [i, text] of texts.entries()) {
        const [name, cell] = rows[i];
        if (cell.textContent === text) continue;
        cell.textContent = text;
        // What a world does not count has no place.
        name.hidden = cell.hidden = text === '';
      }
    },
  };
}
