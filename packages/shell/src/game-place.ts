/** Where a game is. */
export interface GamePlace {
  /** The element of the page that the game fills; undefined if it has the whole page. */
  readonly parent: HTMLElement | undefined;
  /** Address of what is on display; undefined for that of its settings, its seed, its renderer and its plot. */
  readonly link: (() => string) | undefined;
  /** Whether the address of the page is that of the game, which keeps its settings there. */
  readonly ownsAddress: boolean;
}
