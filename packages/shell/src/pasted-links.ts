/**
 * Loads the page anew when the part of its address after # changes: for games that read it as they start. A link to the same page
 * that is pasted while it is open changes that part only, which by itself loads nothing.
 */
export function followPastedLinks(): void {
  addEventListener('hashchange', () => location.reload());
}
