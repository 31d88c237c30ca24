/** Weight of the latest frame in the moving means. */
const WEIGHT = 0.1;

/** Indices of the means. */
export const [FRAME, STEP, DRAW] = [0, 1, 2];

interface Times {
  frame: number;
  step: number;
  draw: number;
}

/** Moving means of milliseconds per frame, per step, and per submission of the world to the renderer. */
export class FrameTimes {
  // A typed array, because fields of objects would be new numbers on the heap in every frame.
  readonly #means = new Float64Array(3);

  /** @param index of a mean, such as `STEP` */
  add(index: number, milliseconds: number): void {
    this.#means[index] += WEIGHT * (milliseconds - this.#means[index]);
  }

  /** Writes the means into `out`, which is returned. */
  copyTo<T extends Times>(out: T): T {
    out.frame = this.#means[FRAME];
    out.step = this.#means[STEP];
    out.draw = this.#means[DRAW];
    return out;
  }
}
