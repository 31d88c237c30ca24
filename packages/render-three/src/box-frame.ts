import type { Box3, Object3D } from 'three';
import { createSegmentLines, type SegmentLinesOptions } from './segment-lines.ts';

/** The twelve edges of an axis-aligned box. */
export interface BoxFrame {
  /** Add it to the scene. */
  readonly object: Object3D;
  /** Draws another box, metres. */
  set(box: Box3): void;
  /** Frees the GPU's memory; remove `object` from the scene yourself. */
  destroy(): void;
}

/**
 * Draws the edges of `box`, metres; a flat box (as of a 2D world) is drawn as its rectangle.
 *
 * @throws Error when the box is empty, a corner of `min` above that of `max`, in `set` too; or when an option is wrong
 */
export function createBoxFrame(box: Box3, options: SegmentLinesOptions = {}): BoxFrame {
  const lines = createSegmentLines(options);
  const set = ({ min, max }: Box3) => {
    if (min.x > max.x || min.y > max.y || min.z > max.z) {
      throw new Error('a box frame needs a box with something in it: give min and max, min below max');
    }
    lines.clear();
    const isFlat = min.z === max.z;
    for (const [x, y] of [
      [min.x, min.y],
      [max.x, min.y],
      [max.x, max.y],
      [min.x, max.y],
    ] as const) {
      // From each corner of the rectangle anticlockwise to the next: to +x, +y, −x, −y in turn.
      const nextX = y === min.y ? max.x : min.x;
      const nextY = x === max.x ? max.y : min.y;
      lines.add(x, y, min.z, nextX, nextY, min.z);
      if (isFlat) continue;
      lines.add(x, y, max.z, nextX, nextY, max.z);
      lines.add(x, y, min.z, x, y, max.z);
    }
  };
  set(box);
  return { object: lines.object, set, destroy: lines.destroy };
}
