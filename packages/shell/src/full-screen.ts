/**
 * Fills the screen with an element, or gives the screen back.
 * @throws Error with a sentence where the browser does not do it
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
    throw new Error('This browser does not give pages the whole screen: add the page to the home screen instead.');
  }
}
