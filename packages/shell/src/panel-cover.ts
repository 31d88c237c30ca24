/** On phones the open panel covers the game, which then waits. */
import { element } from './element.ts';
import type { KeyTarget } from './keyboard.ts';
import type { Layout } from './layout.ts';
import { words } from './words.ts';

/** Closes the panel where it covers the game: by its button, by Escape, and by a tap beside it, which the game does not hear. */
export function closePanelThatCovers(layout: Layout, keys: KeyTarget, signal: AbortSignal): void {
  const close = (event: Event) => {
    event.stopPropagation();
    layout.toggleSidebar(false);
  };
  const button = element('button', 'game-side-close', { type: 'button', 'aria-label': words().close }, '✕');
  layout.sidebar.prepend(button);
  button.addEventListener('click', close);
  const press = (event: Event) => {
    const { key, target } = event as KeyboardEvent;
    if (key === 'Escape' && layout.isCovered && !(target as Element).closest?.('dialog')) close(event);
  };
  keys.addEventListener('keydown', press);
  signal.addEventListener('abort', () => keys.removeEventListener('keydown', press));
  layout.stage.addEventListener('pointerdown', (event) => layout.isCovered && close(event), { capture: true });
}

/** Pauses a running game while the panel covers it. @returns what to call when the panel begins or ceases to cover it */
export function pauseWhileCovered(game: {
  readonly session: { readonly paused: boolean };
  pause(paused: boolean): void;
}): (isCovered: boolean) => void {
  let hasPaused = false;
  return (isCovered) => {
    // A game that the player has paused or resumed since stays so.
    const changes = isCovered ? !game.session.paused : hasPaused && game.session.paused;
    if (changes) game.pause(isCovered);
    hasPaused = isCovered && changes;
  };
}
