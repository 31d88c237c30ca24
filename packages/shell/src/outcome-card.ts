import { element } from './element.ts';
import { HighScores } from './high-scores.ts';

/** How a game ended. */
export interface Outcome {
  /** Such as `Game over`. */
  readonly title: string;
  readonly score: number;
  /** Lines below the title. */
  readonly lines: readonly string[];
}

/** The card at the end of a game. */
export interface OutcomeCard {
  /** Shows the end once; undefined, while the game goes on, hides it. */
  show(outcome: Outcome | undefined): void;
}

/** @param again starts another game @param watch plays this one again, where that can be done */
export function createOutcomeCard(
  parent: HTMLElement,
  game: string,
  again: () => void,
  watch: (() => void) | undefined,
): OutcomeCard {
  const scores = new HighScores(game);
  const title = element('h2', '');
  const text = element('div', '');
  const list = element('ol', '', { 'aria-label': 'High scores' });
  const button = element('button', '', { type: 'button' }, 'Play again');
  const card = element('section', 'game-outcome', { role: 'alert' }, title, text, list, button);
  if (watch !== undefined) {
    const replay = element('button', 'second', { type: 'button' }, 'Watch it');
    replay.addEventListener('click', watch);
    card.append(replay);
  }
  card.hidden = true;
  parent.append(card);
  button.addEventListener('click', () => {
    card.hidden = true;
    again();
  });
  let isOver = false;
  const tell = (outcome: Outcome) => {
    const place = scores.add(outcome.score, new Date().toISOString().slice(0, 10));
    title.textContent = outcome.title;
    const lines = place === 0 ? [...outcome.lines, 'A new high score!'] : outcome.lines;
    text.replaceChildren(...lines.map((line) => element('p', '', {}, line)));
    const rows = scores.list.map(({ score, day }, i) =>
      element('li', i === place ? 'new' : '', {}, element('b', '', {}, String(score)), ` ${day}`),
    );
    list.replaceChildren(...rows);
    button.focus({ preventScroll: true });
  };
  return {
    // Asked in every frame: a function that others are made in makes an object by being called.
    show(outcome) {
      if ((outcome !== undefined) === isOver) return;
      isOver = outcome !== undefined;
      card.hidden = !isOver;
      if (outcome !== undefined) tell(outcome);
    },
  };
}
