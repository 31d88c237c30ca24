import { element } from './element.ts';
import { words } from './words.ts';

/** How a game starts a clip, and shows how far it is. */
export interface ClipControl {
  /** Starts a clip of the seconds that follow, or gives up the one in progress. */
  toggle(): void;
  /** Seconds until the clip is complete; undefined while none is recorded. */
  readonly secondsLeft: number | undefined;
  /** Length of a clip, s. */
  readonly seconds: number;
}

/** A button that starts a clip and counts down while it is recorded. */
export interface ClipButton {
  /** Put it anywhere. */
  readonly button: HTMLButtonElement;
  /** Shows the state; call it a few times a second. */
  update(): void;
}

/**
 * Creates a button that starts a clip and counts down.
 * @param className classes of the button; default none
 * @param idle label while no clip is recorded; default that of the shell
 */
export function createClipButton(clip: ClipControl, className = '', idle = words().clip): ClipButton {
  const button = element('button', className, { type: 'button', 'data-clip': '' });
  button.addEventListener('click', () => clip.toggle());
  let shown = '';
  const update = () => {
    const left = clip.secondsLeft;
    const label = left === undefined ? idle : `● ${Math.ceil(left)} s`;
    button.style.setProperty('--done', String(left === undefined ? 0 : 1 - left / clip.seconds));
    if (label === shown) return;
    shown = label;
    button.textContent = label;
    button.title = left === undefined ? words().clipHint(clip.seconds) : words().clipCancel;
    button.setAttribute('aria-pressed', String(left !== undefined));
  };
  update();
  return { button, update };
}
