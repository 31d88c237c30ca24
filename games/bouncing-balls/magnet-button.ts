/** The button that makes a held press a magnet, for players who do not open the panel. */
import { element } from '@principia/shell';
import { WORDS } from './words.ts';

export interface MagnetButton {
  show(isOn: boolean): void;
  destroy(): void;
}

export function createMagnetButton(parent: HTMLElement, toggle: () => void): MagnetButton {
  const [label, hint] = WORDS.settings.magnet;
  const button = element('button', 'magnet-button', { type: 'button', 'aria-pressed': 'false', title: hint }, label);
  const style = element('style', '', {}, STYLE);
  parent.append(style, button);
  button.addEventListener('click', toggle);
  let shown = false;
  return {
    show(isOn) {
      if (isOn === shown) return;
      shown = isOn;
      button.setAttribute('aria-pressed', String(isOn));
    },
    destroy() {
      style.remove();
      button.remove();
    },
  };
}

const STYLE = `
/* The hint lies beside the buttons. */
@media (pointer: fine) { .game:has(.magnet-button) .game-hint { left: 188px } }
.magnet-button { position: absolute; left: calc(max(20px, env(safe-area-inset-left)) + 76px);
  bottom: max(24px, env(safe-area-inset-bottom)); min-width: 76px; height: 64px; padding: 0 8px;
  border: 1px solid var(--line); border-radius: 20px; background: #ffffff1c; color: var(--ink); font: 600 14px/1 inherit;
  font-family: inherit; touch-action: manipulation; cursor: pointer }
.magnet-button[aria-pressed=true] { background: var(--accent); border-color: transparent; color: #1c1503 }
@media (max-width: 759px), (max-height: 479px) { .game:has(.game-side:not([hidden])) :is(.magnet-button, .tilt-button) { display: none } }
/* A mouse needs less, and the room in 2D reaches far down. */
@media (pointer: fine) { .magnet-button, .game:has(.magnet-button) .game-pad [data-name=action] { bottom: 14px; height: 44px; border-radius: 14px } }
.magnet-button:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px }
`;
