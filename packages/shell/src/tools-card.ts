import type { Actions } from './commands.ts';
import { element } from './element.ts';

/** What the card's switches show. */
export interface ToolsState {
  readonly filming: boolean;
  readonly calm: boolean;
  readonly safeColors: boolean;
}

/** Buttons for pictures, films, the whole screen, and how games look. */
export interface ToolsCard {
  show(state: ToolsState): void;
}

/** @param canReplay whether games can be watched again */
export function createToolsCard(parent: HTMLElement, actions: Actions, canReplay: boolean): ToolsCard {
  const card = element('section', 'game-card game-tools', { 'aria-label': 'Picture' });
  parent.append(card);
  const add = (label: string, title: string, action: () => void) => {
    const button = element('button', '', { type: 'button', title }, label);
    button.addEventListener('click', action);
    card.append(button);
    return button;
  };
  if (canReplay) add('Replay', 'Watch this game from its beginning (Z)', actions.replay);
  add('Picture', 'The picture as a file (I)', actions.picture);
  const film = add('Film', 'Film the game (M)', actions.film);
  add('Whole screen', 'Whole screen (W)', actions.fullScreen);
  const calm = add('Less motion', 'As little motion as possible (X)', actions.calm);
  const colors = add('Safe colours', 'Colours that everybody tells apart (Y)', actions.safeColors);
  return {
    show({ filming, calm: isCalm, safeColors }) {
      film.textContent = filming ? '● Stop' : 'Film';
      film.setAttribute('aria-pressed', String(filming));
      calm.setAttribute('aria-pressed', String(isCalm));
      colors.setAttribute('aria-pressed', String(safeColors));
    },
  };
}
