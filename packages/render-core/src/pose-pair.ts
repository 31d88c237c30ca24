import { checkAlpha } from './arguments.ts';
import type { BodySource } from './body-source.ts';

/**
 * Tracks which of two textures holds the present poses. A step turns the present poses into the previous ones, which
 * are already uploaded: the textures swap roles, and only the new poses are uploaded.
 *
 * Draw with `alphaOf`: interpolation is symmetric, so the shader does not depend on the roles.
 */
export class PosePair {
  /** Incremented with every change of the poses. */
  serial = 0;
  /** Whether the second texture holds the present poses, and the first the previous ones. */
  isSwapped = false;
  /** Whether the last change was exactly one step. */
  isStep = false;
  #pose = Number.NaN;
  #steps = Number.NaN;
  #membership = Number.NaN;

  /** Detects changes of the poses since the last call. */
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

  /**
   * The interpolation factor between the textures for `alpha` between the previous poses, 0, and the present ones, 1.
   * @throws Error where it is no number
   */
  alphaOf(alpha: number): number {
    checkAlpha(alpha);
    return this.isSwapped ? 1 - alpha : alpha;
  }
}

/** The state of textures relative to a `PosePair`. */
export class UploadedPoses {
  #serial = Number.NaN;

  /**
   * Returns the required upload and records it as done.
   *
   * @returns 0 nothing, 1 the present poses, 2 both
   */
  take(pair: PosePair): 0 | 1 | 2 {
    const last = this.#serial;
    this.#serial = pair.serial;
    if (last === pair.serial) return 0;
    return pair.isStep && last === pair.serial - 1 ? 1 : 2;
  }

  /** Forces an upload of both the next time. */
  invalidate(): void {
    this.#serial = Number.NaN;
  }
}
