/**
 * Keeps the focus where players expect it. The stage shows a frame only to those who move the focus by Tab, and what was
 * clicked gives the focus back, so that the space bar pauses instead of pressing the last button again.
 */
export function tendFocus(root: HTMLElement): void {
  root.ownerDocument.addEventListener('keydown', (event) => root.toggleAttribute('data-tabbing', isTab(root, event)));
  root.addEventListener('pointerdown', () => root.removeAttribute('data-tabbing'));
  // A click by keyboard has no pointer, and `detail` is 0.
  root.addEventListener('click', (event) => {
    const target = (event.target as Element).closest<HTMLElement>('button, input[type=checkbox]');
    if (event.detail > 0 && target?.closest('dialog') === null) target.blur();
  });
  root.addEventListener('change', (event) => {
    if (event.target instanceof HTMLSelectElement) event.target.blur();
  });
}

/** Other keys leave the state as it is. */
function isTab(root: HTMLElement, { key }: KeyboardEvent): boolean {
  return key === 'Tab' || root.hasAttribute('data-tabbing');
}
