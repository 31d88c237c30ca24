import { element } from './element.ts';
import { download } from './screenshot.ts';
import { words } from './words.ts';

/** The card on which a clip is seen, shared and saved. */
export interface ClipCard {
  show(file: File): void;
}

/** Whether the system's share sheet takes a file. */
export function canShareFile(file: File): boolean {
  try {
    return typeof navigator.share === 'function' && navigator.canShare?.({ files: [file] }) === true;
  } catch {
    return false;
  }
}

/** Hands a file to the share sheet. @returns a sentence for the player; empty where the sheet has said it all */
export async function shareFile(file: File, title: string): Promise<string> {
  try {
    await navigator.share({ files: [file], title });
    return '';
  } catch (error) {
    // A player who closes the sheet has changed their mind.
    if ((error as Error).name === 'AbortError') return '';
    download(file, file.name);
    return words().clipRefused;
  }
}

/**
 * Browsers open the share sheet only right after a press, so the clip waits on this card for one.
 * @param onMessage receives sentences for the player
 */
export function createClipCard(parent: HTMLElement, title: string, onMessage: (text: string) => void): ClipCard {
  const video = element('video', '', { loop: '', playsinline: '', controls: '', 'aria-label': words().clipCard });
  video.muted = true;
  const add = (label: string, action: (file: File) => void) => {
    const button = element('button', '', { type: 'button' }, label);
    button.addEventListener('click', () => file !== undefined && action(file));
    return button;
  };
  let file: File | undefined;
  let address = '';
  const hide = () => {
    card.hidden = true;
    file = undefined;
    video.removeAttribute('src');
    video.load();
    URL.revokeObjectURL(address);
  };
  const say = (text: string) => text !== '' && onMessage(text);
  const share = add(words().share, (shared) => void shareFile(shared, title).then(say));
  const save = add(words().save, (saved) => download(saved, saved.name));
  const buttons = element('div', '', {}, share, save, add(words().close, hide));
  const card = element('section', 'game-clip', { 'aria-label': words().clipCard }, video, buttons);
  card.hidden = true;
  card.addEventListener('keydown', (event) => event.key === 'Escape' && hide());
  parent.append(card);
  return {
    show(next) {
      if (file !== undefined) hide();
      file = next;
      address = URL.createObjectURL(next);
      video.src = address;
      card.hidden = false;
      // A browser may refuse to play by itself; the controls are there.
      void video.play().catch(() => {});
      share.focus({ preventScroll: true });
    },
  };
}
