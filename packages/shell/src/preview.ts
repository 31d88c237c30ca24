/**
 * `?preview` in the address: only the picture of a game, for a frame in another page such as a card in a list. It has no
 * interface, makes no sound, keeps nothing in the browser's storage, and plays again when it is over. A game that waits for
 * its player may have some of its buttons pressed: `?preview=right,action`.
 */
import type { Controls } from './controls.ts';

/** Seconds for which the end of a game is shown. */
const END_SECONDS = 2;

/** Seconds between two presses of the buttons, how long each lasts, s, and the number of them after which the game restarts. */
const [PRESS_INTERVAL, PRESS_SECONDS, PRESSES] = [4, 1.5, 5];

/** Asked once: a page may write another address later. A worker has an address as well, Node has none. */
const asked = new URLSearchParams(globalThis.location?.search).get('preview');

export const isPreview = asked !== null;

/** What the page around a preview hears when there is a picture that moves. */
export const PICTURE_READY = 'principia picture';

/**
 * Tells the page around this one that there is a picture, and presses buttons until the signal. Any page may show previews.
 */
export function startPreview<Sim>(
  controls: Controls<Sim> | undefined,
  sim: () => Sim,
  restart: () => void,
  signal?: AbortSignal,
): void {
  if (parent !== window) parent.postMessage(PICTURE_READY, '*');
  const names = asked?.split(',').filter((name) => Object.hasOwn(controls?.buttons ?? {}, name)) ?? [];
  if (controls === undefined || names.length === 0) return;
  let presses = 0;
  const press = () => {
    if (presses++ % (PRESSES + 1) === PRESSES) return restart();
    for (const name of names) controls.press(sim(), name);
    setTimeout(() => {
      if (signal?.aborted) return;
      for (const name of names) controls.release(sim(), name);
    }, 1000 * PRESS_SECONDS);
  };
  press();
  const timer = setInterval(press, 1000 * PRESS_INTERVAL);
  signal?.addEventListener('abort', () => clearInterval(timer));
}

/** What stands for the card at the end of a game. @param again starts another game */
export function restartAtEnd(again: () => void): { show(outcome: object | undefined): void } {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return {
    show(outcome) {
      if (outcome === undefined) {
        clearTimeout(timer);
        timer = undefined;
      } else timer ??= setTimeout(again, 1000 * END_SECONDS);
    },
  };
}
