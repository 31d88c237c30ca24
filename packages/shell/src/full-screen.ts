import { words } from './words.ts';

/**
 * Enters full screen with an element, or leaves full screen.
 * @throws Error with a sentence where the browser refuses
 */
export async function toggleFullScreen(target: HTMLElement): Promise<void> {
  if (document.fullscreenElement !== null && document.fullscreenElement !== undefined) {
    await document.exitFullscreen();
    return;
  }
  try {
    if (typeof target.requestFullscreen !== 'function') throw new TypeError('not offered');
    await target.requestFullscreen();
  } catch {
    throw new Error(words().cannotFullScreen);
  }
}
