import { checkOptions, type OptionNames } from '@principia/render-core';
import type { Container } from 'pixi.js';
import { addPoint } from './boxes.ts';
import { bufferLength } from './buffer-capacity.ts';
import { ColumnTexture } from './column-texture.ts';
import { LineColors } from './line-colors.ts';
import { applyLineStyle, checkLength, type LineStyle, lineCount, lineReach } from './line-style.ts';
import { PullMesh } from './pull-mesh.ts';
import { SEGMENT_PROGRAM } from './shaders/segment-program.ts';

/** Straight lines with round ends from numbers: walls, force arrows, debug geometry. */
export interface SegmentLayer {
  /** Add it anywhere, as that of a body layer. */
  readonly container: Container;
  /**
   * Replaces the lines. The numbers are copied, so the array may be reused immediately; no garbage is created.
   *
   * @param segments x1, y1, x2, y2 of each line, metres
   * @param count number of lines; default: all in the array
   * @param colors colour of each line as RGBA bytes in memory order (`0xAABBGGRR`), zero for the layer's colour
   * @throws Error when an array is shorter than `count` lines need, `segments` ends within a line, or `count` is not a whole number
   * from zero; the lines then stay as they are
   */
  set(segments: ArrayLike<number>, count?: number, colors?: ArrayLike<number>): void;
  /** World point, metres, to which the next `set` makes lines relative; see `BodyLayer.setOrigin`. */
  setOrigin(x: number, y: number): void;
  /** Frees the layer's resources and removes it from its parent. */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<LineStyle> = {
  thickness: true,
  color: true,
  opacity: true,
  blendMode: true,
  pixelsPerMetre: true,
};

/** Creates an empty layer of lines. @throws Error when an option is out of range or does not exist */
export function createSegmentLayer(options: LineStyle = {}): SegmentLayer {
  checkOptions(options, OPTION_NAMES, 'createSegmentLayer');
  const segmentsTexture = new ColumnTexture('real', 4);
  const colors = new LineColors();
  const bindings = { uSegments: segmentsTexture.source, uLineColors: colors.texture.source };
  const { pixelsPerMetre = 1, blendMode = 'normal', thickness } = options;
  let data = new Float32Array(0);
  let lines = 0;
  const mesh = new PullMesh(SEGMENT_PROGRAM, bindings, pixelsPerMetre, blendMode, (box, pixel) => {
    for (let i = 0; i < 4 * lines; i += 2) addPoint(box, data[i], data[i + 1], lineReach(thickness, pixel));
  });
  applyLineStyle(mesh, options);
  let originX = 0;
  let originY = 0;
  let live = true;

  return {
    container: mesh.container,
    set(segments, wanted, lineColors) {
      mesh.assertDrawable();
      const count = lineCount('segments', segments, 4, wanted);
      if (lineColors !== undefined) checkLength('colors', lineColors, count);
      const length = bufferLength(count, data.length, 4);
      if (length !== data.length) data = new Float32Array(length);
      for (let i = 0; i < 4 * count; i += 2) {
        data[i] = segments[i] - originX;
        data[i + 1] = segments[i + 1] - originY;
      }
      lines = count;
      segmentsTexture.upload(data, count);
      colors.set(count, lineColors);
      mesh.place(originX, originY);
      mesh.draw(count);
    },
    setOrigin(x, y) {
      originX = x;
      originY = y;
    },
    destroy() {
      if (!live) return;
      live = false;
      mesh.destroy();
      segmentsTexture.destroy();
      colors.texture.destroy();
    },
  };
}
