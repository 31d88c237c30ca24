import type { BodySource } from './body-source.ts';

/**
 * Which half of a pair of textures holds the present poses. A step makes the present ones the previous ones, so that
 * what was sent as present a frame ago need not be sent again: the halves change roles, and only the new poses are sent.
 *
 * Draw between the halves with `alphaOf`: blending is symmetric, so that a shader need not know about roles.
 */
export class PosePair {
  /** Grows with every change of the poses. */
  serial = 0;
  /** Whether the second half holds the present poses, and the first the previous ones. */
  isSwapped = false;
  /** Whether the last change was a single step, and nothing else. */
  isStep = false;
  #pose = Number.NaN;
  #steps = Number.NaN;
  #membership = Number.NaN;

  /** Looks what has happened to the poses since the last call. */
  refresh({ versions }: BodySource): void {
    const { pose, steps, membership } = versions;
    if (pose === this.#pose && membership === this.#membership) return;
    this.isStep = pose === this.#pose + 1 && steps === this.#steps + 1 && membership === this.#membership;
    if (this.isStep) this.isSwapped = !this.isSwapped;
    this.#pose = pose;
    this.#steps = steps ?? Number.NaN;
    this.#membership = membership;
    this.serial++;
  }

  /** What a shader blends the halves with to draw at `alpha` between the previous poses, 0, and the present ones, 1. */
  alphaOf(alpha: number): number {
    return this.isSwapped ? 1 - alpha : alpha;
  }
}

/** What textures have of a `PosePair`. */
export class UploadedPoses {
  #serial = Number.NaN;

  /**
   * What has to be sent now for the pair to be as the source is; counts as sent from then on.
   *
   * @returns 0 nothing, 1 the present poses into their half, 2 both
   */
  take(pair: PosePair): 0 | 1 | 2 {
    const last = this.#serial;
    this.#serial = pair.serial;
    if (last === pair.serial) return 0;
    return pair.isStep && last === pair.serial - 1 ? 1 : 2;
  }

  /** Has both sent the next time. */
  invalidate(): void {
    this.#serial = Number.NaN;
  }
}
