import { element } from './element.ts';

/** A message at the bottom of the page. */
export interface Banner {
  /** The text on display; empty when the banner is hidden. */
  readonly text: string;
  /** @param action label and handler of an extra button; the close button always hides the banner */
  show(text: string, kind: 'error' | 'note', action?: readonly [string, () => void]): void;
  hide(): void;
}

export function createBanner(parent: HTMLElement): Banner {
  const text = element('p', '');
  const act = element('button', '', { type: 'button' });
  const close = element('button', '', { type: 'button', 'aria-label': 'Hide this message' }, '✕');
  const box = element('div', 'game-banner', { role: 'alert' }, text, act, close);
  box.hidden = true;
  parent.append(box);
  const hide = () => {
    box.hidden = true;
    text.textContent = '';
  };
  close.addEventListener('click', hide);
  return {
    get text() {
      return text.textContent ?? '';
    },
    show(message, kind, action) {
      if (text.textContent === message) return;
      text.textContent = message;
      box.dataset.kind = kind;
      act.hidden = action === undefined;
      act.textContent = action?.[0] ?? '';
      act.onclick = () => {
        hide();
        action?.[1]();
      };
      box.hidden = false;
    },
    hide,
  };
}
