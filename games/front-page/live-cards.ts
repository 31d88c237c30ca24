/**
 * Cards that come alive: while a pointer or the keyboard's focus rests on one, the game itself runs in place of its picture.
 * One at most, and nothing else moves meanwhile.
 */
import type { LiveScene } from './scene.ts';

/** How long a pointer rests on a card before it comes alive, ms: longer than it takes to cross one. */
const REST = 400;
/** As the shell of the games says it (`PICTURE_READY`); this page loads nothing of the shell. */
const PICTURE_READY = 'principia picture';

/** What a visitor asked the browser to save, which not every browser tells. */
type Connection = { readonly saveData?: boolean };

/**
 * Lets cards come alive, where there is a pointer that can hover, motion is welcome, and data need not be saved.
 * @param cards with the address of a preview in `data-live`
 * @param scene stands still while a card is alive
 */
export function enliven(cards: Iterable<HTMLElement>, scene: LiveScene | undefined): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let rested: HTMLElement | undefined;
  let frame: HTMLIFrameElement | undefined;
  const leave = (card = rested) => {
    if (card === undefined || card !== rested) return;
    clearTimeout(timer);
    rested = undefined;
    if (frame === undefined) return;
    frame.remove();
    frame = undefined;
    scene?.resume();
  };
  const wake = (card: HTMLElement) => {
    scene?.pause();
    frame = createFrame(card.dataset.live as string);
    // Behind the link, whose outline shows the focus.
    card.prepend(frame);
  };
  const rest = (card: HTMLElement) => {
    if (card === rested || !isWelcome()) return;
    leave();
    rested = card;
    timer = setTimeout(() => wake(card), REST);
  };
  for (const card of cards) {
    card.addEventListener('pointerenter', ({ pointerType }) => pointerType !== 'touch' && rest(card));
    card.addEventListener('pointerleave', () => leave(card));
    card.addEventListener('focusin', ({ target }) => (target as Element).matches(':focus-visible') && rest(card));
    card.addEventListener('focusout', () => leave(card));
  }
  // The still picture stays until the game has one.
  addEventListener('message', ({ source, data }) => {
    if (data === PICTURE_READY && frame !== undefined && source === frame.contentWindow) frame.dataset.ready = '';
  });
  // No pointer leaves a card that the search takes away, nor a page that is left or covered.
  for (const type of ['input', 'visibilitychange']) document.addEventListener(type, () => leave());
  addEventListener('pagehide', () => leave());
}

/** Asked each time, as a visitor may change these while the page is open. */
function isWelcome(): boolean {
  const { connection } = navigator as { readonly connection?: Connection };
  const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
  return matchMedia('(hover: hover)').matches && !isStill && connection?.saveData !== true;
}

/** A frame that neither pointers, nor keys, nor screen readers meet. */
function createFrame(address: string): HTMLIFrameElement {
  const frame = document.createElement('iframe');
  frame.inert = true;
  frame.tabIndex = -1;
  frame.ariaHidden = 'true';
  frame.allow = "autoplay 'none'";
  frame.src = address;
  return frame;
}
