import { element } from './element.ts';
import { HighScores } from './high-scores.ts';
import { dayOf } from './local-day.ts';
import { isPreview, restartAtEnd } from './preview.ts';
import { words } from './words.ts';

/** The result of a game. */
export interface Outcome {
  /** For example `Game over`. */
  readonly title: string;
  /** For the high scores, if above 0. */
  readonly score: number;
  /** Lines below the title. */
  readonly lines: readonly string[];
  /** The result in a line, to be shared with a link to the same game. Default none: nothing is shared. */
  readonly share?: string;
  /** Seed of the game that follows; default the next number. */
  readonly nextSeed?: number;
}

/** The card at the end of a game. */
export interface OutcomeCard {
  /**
   * Shows the result once; undefined hides the card.
   * @param isRanked false for a player who rewound, whose score does not count
   */
  show(outcome: Outcome | undefined, isRanked?: boolean): void;
}

/**
 * @param again starts another game
 * @param watch replays this one, if possible
 * @param share shares a line and a link to this game
 */
export function createOutcomeCard(
  parent: HTMLElement,
  game: string,
  again: () => void,
  watch: (() => void) | undefined,
  share: (text: string) => void,
): OutcomeCard {
  if (isPreview) return restartAtEnd(again);
  const scores = new HighScores(game);
  const title = element('h2', '');
  const lines = element('div', '');
  const list = element('ol', '', { 'aria-label': words().highScores });
  const button = element('button', '', { type: 'button' }, words().playAgain);
  const card = element('section', 'game-outcome', { role: 'alert', 'data-filmed': '' }, title, lines, list, button);
  if (watch !== undefined) {
    const replay = element('button', 'second', { type: 'button' }, words().watchReplay);
    replay.addEventListener('click', watch);
    card.append(replay);
  }
  const send = element('button', 'second', { type: 'button' }, words().shareResult);
  let text = '';
  send.addEventListener('click', () => share(text));
  card.append(send);
  card.hidden = true;
  parent.append(card);
  button.addEventListener('click', () => {
    card.hidden = true;
    again();
  });
  let isOver = false;
  const showOutcome = (outcome: Outcome, isRanked: boolean) => {
    const rank = isRanked ? scores.add(outcome.score, dayOf(new Date())) : -1;
    title.textContent = outcome.title;
    const more = isRanked ? (rank === 0 ? [words().newHighScore] : []) : [words().notRanked];
    const texts = [...outcome.lines, ...more];
    lines.replaceChildren(...texts.map((line) => element('p', '', {}, line)));
    const rows = scores.list.map(({ score, day }, i) =>
      element('li', i === rank ? 'new' : '', {}, element('b', '', {}, String(score)), ` ${day}`),
    );
    list.replaceChildren(...rows);
    text = outcome.share ?? '';
    send.hidden = text === '';
    // Who types elsewhere on the page goes on typing.
    const { activeElement } = document;
    if (activeElement === document.body || parent.contains(activeElement)) button.focus({ preventScroll: true });
  };
  return {
    // Called in every frame: a function that contains closures would allocate in each call, so this one has none.
    show(outcome, isRanked = true) {
      if ((outcome !== undefined) === isOver) return;
      isOver = outcome !== undefined;
      card.hidden = !isOver;
      if (outcome !== undefined) showOutcome(outcome, isRanked);
    },
  };
}
