/** Seconds that a picture is drawn in every frame after something happened: a camera that was pushed glides that long. */
const AWAKE = 1;
/** Seconds between two pictures of a world that stands: what comes late, such as an image of a planet, is seen that soon. */
const REST = 0.25;

const EVENTS = ['pointerdown', 'pointermove', 'pointerup', 'wheel', 'keydown', 'keyup', 'click', 'input', 'change'];

/**
 * Decides which frames are drawn. A world that stands, as in a paused game, is drawn a few times a second, so that it hardly uses a
 * battery; one that moves, and what the player has just touched or resized, in every frame.
 */
export class DrawingRate {
  #awake = AWAKE;
  #undrawn = 0;

  /** Hears what the player does on the page, and that `stage` gets another size. @param signal ends that */
  listen(stage: Element, signal: AbortSignal): void {
    const wake = () => this.wake();
    for (const name of EVENTS) document.addEventListener(name, wake, { capture: true, passive: true, signal });
    const sizes = new ResizeObserver(wake);
    sizes.observe(stage);
    signal.addEventListener('abort', () => sizes.disconnect());
  }

  /** Something changed that is to be seen at once. */
  wake(): void {
    this.#awake = AWAKE;
  }

  /**
   * @param seconds since the last frame
   * @param stands whether the world has not changed since then
   * @returns seconds since the last frame that was drawn, if this one is to be drawn, or else -1
   */
  next(seconds: number, stands: boolean): number {
    this.#awake = stands ? this.#awake - seconds : AWAKE;
    this.#undrawn += seconds;
    if (this.#awake <= 0 && this.#undrawn < REST) return -1;
    const since = this.#undrawn;
    this.#undrawn = 0;
    return since;
  }
}
