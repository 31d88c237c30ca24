import { element } from './element.ts';
import type { Insets } from './game.ts';
import { addStyles, NARROW } from './styles.ts';

/** The parts of a game's page, from back to front. */
export interface Layout {
  readonly root: HTMLElement;
  /** Fills the window; the canvas goes here. */
  readonly stage: HTMLElement;
  readonly bar: HTMLElement;
  /** Panel, plot and figures, one below the other. */
  readonly side: HTMLElement;
  /** Room that bar and side take away from the stage. */
  insets(): Insets;
  /** Shows or hides the side; without an argument, the other way round. */
  toggleSide(shown?: boolean): void;
}

/** Builds the page of a game. */
export function createLayout(title: string, onSide: () => void): Layout {
  addStyles();
  const stage = element('div', 'game-stage');
  const bar = element('header', 'game-bar', {}, element('h1', 'game-title', {}, title));
  const side = element('aside', 'game-side', { 'aria-label': 'Settings and measurements' });
  const root = element('div', 'game', {}, stage, bar, side);
  document.body.append(root);
  /** Games ask in every frame. */
  const covered = { top: 0, right: 0, bottom: 0, left: 0 };
  const narrow = matchMedia(NARROW);
  let shown = !narrow.matches;
  side.hidden = !shown;
  return {
    root,
    stage,
    bar,
    side,
    insets() {
      const right = shown && !narrow.matches ? side.offsetWidth + 16 : 0;
      covered.top = bar.offsetHeight;
      covered.right = right;
      return covered;
    },
    toggleSide(wanted = !shown) {
      shown = wanted;
      side.hidden = !shown;
      onSide();
    },
  };
}
