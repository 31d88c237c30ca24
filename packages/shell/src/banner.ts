import { element } from './element.ts';
import { words } from './words.ts';

/**
 * `error` stays until it is closed or mended; `note` leaves by itself; `status` stays until the state that it names ends.
 */
export type BannerKind = 'error' | 'note' | 'status';

/** A message on the page. */
export interface Banner {
  /** The text on display; empty when the banner is hidden. */
  readonly text: string;
  readonly kind: BannerKind;
  /**
   * A note does not replace an error: it is shown below it, and leaves by itself.
   * @param action label and handler of an extra button; the close button always hides the banner
   */
  show(text: string, kind: BannerKind, action?: readonly [string, () => void]): void;
  /** Shows a note below what is on display already. */
  add(note: string): void;
  hide(): void;
}

/** Time that a note stays, ms: a moment to notice it, and time to read it at 15 characters a second. */
const NOTE_MS = { least: 4000, perCharacter: 66 } as const;

export function createBanner(parent: HTMLElement): Banner {
  const text = element('p', '');
  const act = element('button', '', { type: 'button' });
  const close = element('button', '', { type: 'button', 'aria-label': words().hideMessage }, '✕');
  const below = element('p', '');
  const box = element('div', 'game-banner', { role: 'alert' }, element('div', '', {}, text, below), act, close);
  box.hidden = true;
  below.hidden = true;
  parent.append(box);
  let kind: BannerKind = 'note';
  let timer = 0;
  const showBelow = (note: string) => {
    clearTimeout(timer);
    below.textContent = note;
    below.hidden = note === '';
    if (note !== '') leaveLater(note);
  };
  const hide = () => {
    showBelow('');
    box.hidden = true;
    text.textContent = '';
  };
  const leave = () => {
    // A note under the pointer or with the focus is being read or used.
    if (box.matches(':hover, :focus-within')) timer = window.setTimeout(leave, 1000);
    else if (kind === 'error') showBelow('');
    else hide();
  };
  close.addEventListener('click', hide);
  const leaveLater = (message: string) => {
    clearTimeout(timer);
    timer = window.setTimeout(leave, NOTE_MS.least + NOTE_MS.perCharacter * message.length);
  };
  const banner: Banner = {
    get text() {
      return below.hidden ? `${text.textContent}` : `${text.textContent}\n${below.textContent}`;
    },
    get kind() {
      return kind;
    },
    show(message, messageKind, action) {
      if (messageKind === 'note' && kind === 'error' && !box.hidden) return showBelow(message);
      // An error that comes with every frame leaves the note below it its time.
      if (messageKind === 'error' && text.textContent === message) return;
      showBelow('');
      if (messageKind === 'note') leaveLater(message);
      if (text.textContent === message) return;
      kind = messageKind;
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
    add(note) {
      if (box.hidden) banner.show(note, 'note');
      else {
        text.textContent += `\n${note}`;
        if (kind === 'note') leaveLater(banner.text);
      }
    },
    hide,
  };
  return banner;
}
