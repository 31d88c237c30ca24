/** Fits the stage into the part of the window that nothing covers; a tall window follows the ship across it. */
import { type Camera2D, fit, follow } from '@principia/render-core';
import { BLACK_HOLE } from '@principia/scenes';
import { hasCoarsePointer, type Insets } from '@principia/shell';

const MARGIN = 14;
const { width: STAGE_WIDTH, height: STAGE_HEIGHT } = BLACK_HOLE;
const WHOLE_STAGE = { minX: 0, minY: 0, maxX: STAGE_WIDTH, maxY: STAGE_HEIGHT };

/** Width that a tall window shows at least, m. */
const MIN_VISIBLE_WIDTH = 500;
/** Height of the text above and below the stage, and of the stick, CSS pixels. */
const [ABOVE, BELOW, STICK] = [54, 44, 170];
/** Time constant with which the view follows the ship, s. */
const FOLLOW_TIME = 0.25;

type Size = { readonly width: number; readonly height: number };

export class StageCamera {
  readonly camera: Camera2D = { x: STAGE_WIDTH / 2, y: STAGE_HEIGHT / 2, pixelsPerMetre: 1 };
  zoom = 1;
  readonly #velocity = { x: 0, y: 0 };
  readonly #isTouch = hasCoarsePointer();
  readonly #free = { width: 0, height: 0 };

  /** @param shipX position of the ship, m */
  update({ top, right, bottom, left }: Insets, size: Size, shipX: number, seconds: number): void {
    const { camera } = this;
    const free = this.#free;
    free.width = size.width - left - right;
    free.height = size.height - top - bottom;
    if (!(free.width > 0 && free.height > 0)) return;
    if (this.#isTouch && free.height > free.width) {
      this.#fitTall(shipX, seconds);
    } else {
      fit(camera, WHOLE_STAGE, free, MARGIN);
      // The stick covers the lower right, so the stage moves to the left.
      if (this.#isTouch) camera.x += (free.width / 2 - MARGIN) / camera.pixelsPerMetre - STAGE_WIDTH / 2;
    }
    camera.pixelsPerMetre *= this.zoom;
    camera.x += (right - left) / 2 / camera.pixelsPerMetre;
    camera.y += (top - bottom) / 2 / camera.pixelsPerMetre;
  }

  /** Fills the height above the stick, and shows the part of the width where the ship is. */
  #fitTall(shipX: number, seconds: number): void {
    const { camera } = this;
    const free = this.#free;
    const previousX = camera.x;
    fit(camera, WHOLE_STAGE, free, MARGIN);
    const byHeight = (free.height - ABOVE - BELOW - STICK) / STAGE_HEIGHT;
    camera.pixelsPerMetre = Math.max(camera.pixelsPerMetre, Math.min(byHeight, free.width / MIN_VISIBLE_WIDTH));
    // The upper edge of the stage lies below the text.
    camera.y = STAGE_HEIGHT - (free.height / 2 - ABOVE) / camera.pixelsPerMetre;
    const half = free.width / 2 / camera.pixelsPerMetre;
    if (half >= STAGE_WIDTH / 2) return;
    const wanted = Math.min(STAGE_WIDTH - half, Math.max(half, shipX));
    camera.x = previousX;
    const { y } = camera;
    follow(camera, this.#velocity, wanted, y, FOLLOW_TIME, Math.min(seconds, 0.1));
    camera.y = y;
    camera.x = Math.min(STAGE_WIDTH - half, Math.max(half, camera.x));
  }
}
