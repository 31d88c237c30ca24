import { type ClipControl, createClipButton } from './clip-button.ts';
import type { Actions } from './commands.ts';
import { element } from './element.ts';

/** The state of the card's switches. */
export interface ToolsState {
  readonly recording: boolean;
  readonly reducedMotion: boolean;
  readonly safeColors: boolean;
}

/** Buttons for screenshots, video, full screen and appearance. */
export interface ToolsCard {
  show(state: ToolsState): void;
}

/** @param canReplay whether games can be replayed */
export function createToolsCard(
  parent: HTMLElement,
  actions: Actions,
  clip: ClipControl,
  canReplay: boolean,
): ToolsCard {
  const card = element('section', 'game-card game-tools', { 'aria-label': 'Picture' });
  parent.append(card);
  const add = (label: string, title: string, action: () => void) => {
    const button = element('button', '', { type: 'button', title }, label);
    button.addEventListener('click', action);
    card.append(button);
    return button;
  };
  if (canReplay) add('Replay', 'Replay this game from its beginning (Z)', actions.replay);
  add('Copy link', 'Copy a link to this game with its settings and seed', actions.copyLink);
  const clipButton = createClipButton(clip);
  card.append(clipButton.button);
  add('Screenshot', 'Save a screenshot (I)', actions.screenshot);
  const video = add('Record video', 'Record video (J)', actions.recordVideo);
  add('Full screen', 'Full screen (W)', actions.fullScreen);
  const motion = add('Reduced motion', 'Reduced motion (X)', actions.reducedMotion);
  const colors = add('Colour-blind palette', 'Colour-blind palette (Y)', actions.safeColors);
  return {
    show({ recording, reducedMotion, safeColors }) {
      clipButton.update();
      video.textContent = recording ? '● Stop' : 'Record video';
      video.setAttribute('aria-pressed', String(recording));
      motion.setAttribute('aria-pressed', String(reducedMotion));
      colors.setAttribute('aria-pressed', String(safeColors));
    },
  };
}
