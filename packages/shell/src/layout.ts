import { element } from './element.ts';
import type { Insets } from './game.ts';
import { addStyles, NARROW } from './styles.ts';

/** The elements of a game's page, from back to front. */
export interface Layout {
  readonly root: HTMLElement;
  /** The container of the canvas; fills the window. */
  readonly stage: HTMLElement;
  readonly bar: HTMLElement;
  /** Settings, plot and statistics, from top to bottom. */
  readonly sidebar: HTMLElement;
  /** Margins of the stage that toolbar and sidebar cover. */
  insets(): Insets;
  /** Shows or hides the sidebar; without an argument, toggles it. */
  toggleSidebar(shown?: boolean): void;
}

/** Builds the page of a game. */
export function createLayout(title: string, onSidebar: () => void): Layout {
  addStyles();
  const stage = element('div', 'game-stage');
  const bar = element('header', 'game-bar', {}, element('h1', 'game-title', {}, title));
  const sidebar = element('aside', 'game-side', { 'aria-label': 'Settings and measurements' });
  const root = element('div', 'game', {}, stage, bar, sidebar);
  document.body.append(root);
  /** Reused because games ask in every frame. */
  const covered = { top: 0, right: 0, bottom: 0, left: 0 };
  const narrow = matchMedia(NARROW);
  let shown = !narrow.matches;
  sidebar.hidden = !shown;
  return {
    root,
    stage,
    bar,
    sidebar,
    insets() {
      const right = shown && !narrow.matches ? sidebar.offsetWidth + 16 : 0;
      covered.top = bar.offsetHeight;
      covered.right = right;
      return covered;
    },
    toggleSidebar(wanted = !shown) {
      shown = wanted;
      sidebar.hidden = !shown;
      onSidebar();
    },
  };
}
