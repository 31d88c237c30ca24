/**
 * Keeps the focus where players expect it. The stage shows a frame only to those who move the focus by Tab, and what was
 * clicked gives the focus back, so that the space bar pauses instead of pressing the last button again: to the page, or in
 * a game that is a part of the page to the game, which hears no keys otherwise.
 */
export function tendFocus(root: HTMLElement, isInside: boolean, signal: AbortSignal): void {
  const noteKey = (event: KeyboardEvent) => root.toggleAttribute('data-tabbing', isTab(root, event));
  root.ownerDocument.addEventListener('keydown', noteKey, { signal });
  const giveBack = (element: HTMLElement) => (isInside ? root.focus({ preventScroll: true }) : element.blur());
  if (isInside) root.tabIndex = -1;
  root.addEventListener('pointerdown', () => root.removeAttribute('data-tabbing'));
  // A click by keyboard has no pointer, and `detail` is 0.
  root.addEventListener('click', (event) => {
    const target = (event.target as Element).closest<HTMLElement>('button, input[type=checkbox]');
    if (event.detail > 0 && target?.closest('dialog') === null) giveBack(target);
  });
  root.addEventListener('change', (event) => {
    if (event.target instanceof HTMLSelectElement) giveBack(event.target);
  });
}

/** Other keys leave the state as it is. */
function isTab(root: HTMLElement, { key }: KeyboardEvent): boolean {
  return key === 'Tab' || root.hasAttribute('data-tabbing');
}
