import { type ClipControl, createClipButton } from './clip-button.ts';
import type { Actions } from './commands.ts';
import { element } from './element.ts';
import { words } from './words.ts';

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
  const card = element('section', 'game-card game-tools', { 'aria-label': words().picture });
  parent.append(card);
  const add = (label: string, title: string, action: () => void) => {
    const button = element('button', '', { type: 'button', title }, label);
    button.addEventListener('click', action);
    card.append(button);
    return button;
  };
  if (canReplay) add(words().replay, words().replayHint, actions.replay);
  add(words().copyLink, words().copyLinkHint, actions.copyLink);
  const clipButton = createClipButton(clip);
  card.append(clipButton.button);
  add(words().screenshot, words().screenshotHint, actions.screenshot);
  const video = add(words().record, words().recordHint, actions.recordVideo);
  add(words().fullScreen, `${words().fullScreen} (W)`, actions.fullScreen);
  const motion = add(words().motionTool, `${words().motionTool} (X)`, actions.reducedMotion);
  const colors = add(words().colorsTool, `${words().colorsTool} (Y)`, actions.safeColors);
  return {
    show({ recording, reducedMotion, safeColors }) {
      clipButton.update();
      video.textContent = recording ? words().recordStop : words().record;
      video.setAttribute('aria-pressed', String(recording));
      motion.setAttribute('aria-pressed', String(reducedMotion));
      colors.setAttribute('aria-pressed', String(safeColors));
    },
  };
}
