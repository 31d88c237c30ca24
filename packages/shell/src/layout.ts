import { element } from './element.ts';
import type { Insets } from './game.ts';
import { isPreview } from './preview.ts';
import { addStyles, isNarrow } from './styles.ts';
import { words } from './words.ts';

/** The elements of a game's page, from back to front. */
export interface Layout {
  readonly root: HTMLElement;
  /** The container of the canvas; fills the window. */
  readonly stage: HTMLElement;
  readonly bar: HTMLElement;
  /** Settings, plot and statistics, from top to bottom. */
  readonly sidebar: HTMLElement;
  /** Margins of the stage that toolbar, sidebar and timeline cover. */
  insets(): Insets;
  /** Whether the sidebar covers the game, as it does on phones. */
  readonly isCovered: boolean;
  /** Shows or hides the sidebar; without an argument, toggles it. */
  toggleSidebar(shown?: boolean): void;
}

export interface LayoutOptions {
  readonly title: string;
  /** Element that the game fills; undefined for the whole window. */
  readonly parent: HTMLElement | undefined;
  /** On phones the sidebar is a sheet below or beside the picture, and open at the start; default false. */
  readonly isSheet?: boolean | undefined;
  /** Called when the sidebar was shown or hidden. */
  readonly onSidebar: () => void;
  /** Called when the sidebar begins or ceases to cover the game, as it does on phones. */
  readonly onCover: (isCovered: boolean) => void;
  /** Ends the layout: it removes its elements. */
  readonly signal: AbortSignal;
}

/** Builds the elements of a game. */
export function createLayout({ title, parent, isSheet = false, onSidebar, onCover, signal }: LayoutOptions): Layout {
  addStyles();
  const stage = element('div', 'game-stage');
  const bar = element('header', 'game-bar', {}, element('h1', 'game-title', {}, title));
  const sidebar = element('aside', 'game-side', { 'aria-label': words().measurements });
  const root = element('div', isSheet ? 'game game-sheet' : 'game', {}, stage, bar, sidebar);
  root.toggleAttribute('data-preview', isPreview);
  root.classList.toggle('game-inside', parent !== undefined);
  (parent ?? document.body).append(root);
  /** Reused because games ask in every frame. */
  const covered = { top: 0, right: 0, bottom: 0, left: 0 };
  let narrow = isNarrow(root);
  let shown = !isPreview && (isSheet || !narrow);
  sidebar.hidden = !shown;
  let isCovered = false;
  const noteCover = () => {
    const before = isCovered;
    isCovered = shown && narrow && !isSheet;
    if (isCovered !== before) onCover(isCovered);
  };
  const toggleSidebar = (wanted = !shown) => {
    shown = wanted;
    sidebar.hidden = !shown;
    onSidebar();
    noteCover();
  };
  const watch = new ResizeObserver(() => {
    // In a small window the bar has several rows, and what stands below it moves down.
    root.style.setProperty('--bar', `${bar.offsetHeight}px`);
    const before = narrow;
    narrow = isNarrow(root);
    // A window that becomes narrow shows the game, which the sidebar would cover.
    if (narrow && !before && shown && !isSheet) toggleSidebar(false);
    else noteCover();
  });
  watch.observe(root);
  watch.observe(bar);
  signal.addEventListener('abort', () => {
    watch.disconnect();
    root.remove();
  });
  return {
    root,
    stage,
    bar,
    sidebar,
    insets() {
      const isBelow = isSheet && sidebar.offsetTop > root.offsetHeight / 3;
      const isBeside = shown && !isBelow && (isSheet || !narrow);
      covered.top = bar.offsetHeight;
      covered.right = isBeside ? sidebar.offsetWidth + 16 : 0;
      covered.bottom = Math.max(shown && isBelow ? sidebar.offsetHeight : 0, coveredBottom(root));
      return covered;
    },
    toggleSidebar,
    get isCovered() {
      return isCovered;
    },
  };
}

/** Height at the bottom that elements with the attribute `data-covers="bottom"` cover, CSS pixels. Makes no garbage. */
function coveredBottom({ children, offsetHeight }: HTMLElement): number {
  let covered = 0;
  for (let i = 0; i < children.length; i++) {
    const panel = children[i] as HTMLElement;
    // What a style sheet or the attribute `hidden` hides covers nothing.
    if (panel.getAttribute('data-covers') !== 'bottom' || panel.offsetHeight === 0) continue;
    covered = Math.max(covered, offsetHeight - panel.offsetTop);
  }
  return covered;
}
