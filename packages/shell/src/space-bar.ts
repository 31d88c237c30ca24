/**
 * The space bar pauses when it is released, unless a pointer was pressed while it was down: then it was held to move the
 * view, as in drawing programs.
 */
export class SpaceBar {
  isHeld = false;
  #wasUsed = false;
  readonly #onTap: () => void;

  /** @param stage element in which a drag moves the view @param onTap called when the bar was pressed without a drag */
  constructor(stage: HTMLElement, onTap: () => void) {
    this.#onTap = onTap;
    const use = () => {
      this.#wasUsed ||= this.isHeld;
    };
    stage.addEventListener('pointerdown', use, { capture: true });
  }

  /** @param isLost let go because the page lost the focus, which is no tap */
  set(down: boolean, isLost = false): void {
    if (down === this.isHeld) return;
    this.isHeld = down;
    if (!down && !this.#wasUsed && !isLost) this.#onTap();
    this.#wasUsed = false;
  }
}
