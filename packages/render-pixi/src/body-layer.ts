import type { BodySource } from '@principia/render-core';
import type { Container } from 'pixi.js';
import { writeColor } from './color.ts';
import { PullMesh } from './pull-mesh.ts';
import { BODY_PROGRAM } from './shaders/body-program.ts';
import { SourceTextures } from './source-textures.ts';

/** How a body layer draws. */
export interface BodyLayerOptions {
  source: BodySource;
  /** Pixels of the layer's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
  /** Colour of bodies whose colour is 0, as 0xRRGGBB; default 0x4f9dde. */
  defaultColor?: number;
  /** `add` lets overlapping bodies brighten each other, as fire and stars do; default `normal`. */
  blendMode?: 'normal' | 'add';
  /** Radius below which no body is drawn however small it is, physical pixels; default 0.5. */
  minimumPixels?: number;
  /** False leaves the angles of boxes and marked discs out. Default true. */
  rotation?: boolean;
}

/** Bodies of a world, to be added to a pixi stage. */
export interface BodyLayer {
  /** Add it where you like. Its coordinates are metres times `pixelsPerMetre`, with y up. */
  readonly container: Container;
  /**
   * Brings the picture up to date; call it once a frame before rendering. Uploads what changed since the last call and
   * leaves no garbage behind.
   *
   * @param alpha where between the previous (0) and the present pose (1) to draw
   */
  update(alpha: number): void;
  /**
   * Sets the world point, metres, near which an f64 source is drawn precisely; move it along with the camera in a world
   * too large for f32. Without effect for an f32 source. Applies to every layer of the same source.
   */
  setOrigin(x: number, y: number): void;
  /** Frees the layer's own resources and takes it off its parent. */
  destroy(): void;
}

/**
 * Draws every body of a source as a disc, ring, box, marked disc or glow. The GPU reads the world's own columns by
 * entity id, so the cost in JavaScript is one upload per changed column, whatever the number of bodies.
 *
 * @throws Error when an option is out of range or the source's rows are not a multiple of 1024
 */
export function createBodyLayer(options: BodyLayerOptions): BodyLayer {
  const { source, pixelsPerMetre = 1, defaultColor = 0x4f9dde, blendMode = 'normal' } = options;
  const { minimumPixels = 0.5, rotation = true } = options;
  const color = new Float32Array(4);
  writeColor(color, defaultColor);
  if (!(minimumPixels > 0)) throw new Error(`minimumPixels must be above zero, got ${minimumPixels}`);
  const textures = SourceTextures.acquire(source);
  const mesh = new PullMesh(BODY_PROGRAM, bindings(textures), pixelsPerMetre, blendMode);
  mesh.uniforms.uDefaultColor = color;
  mesh.uniforms.uMinimumPixels = minimumPixels;
  let live = true;

  return {
    container: mesh.container,
    update(alpha) {
      textures.syncIds();
      textures.syncPosition();
      textures.syncStyle();
      if (rotation) textures.syncAngle();
      mesh.uniforms.uAlpha = textures.alphaOf(alpha);
      mesh.place(textures.originX, textures.originY);
      mesh.draw(source.count);
    },
    setOrigin(x, y) {
      textures.setOrigin(x, y);
    },
    destroy() {
      if (!live) return;
      live = false;
      mesh.destroy();
      textures.release();
    },
  };
}

function bindings(textures: SourceTextures) {
  return {
    uIds: textures.ids.source,
    uX: textures.x.texture.source,
    uY: textures.y.texture.source,
    uPreviousX: textures.previousX.texture.source,
    uPreviousY: textures.previousY.texture.source,
    uAngle: textures.angle.texture.source,
    uPreviousAngle: textures.previousAngle.texture.source,
    uRadius: textures.radius.texture.source,
    uSize: textures.size.texture.source,
    uBodyColor: textures.color.source,
    uShape: textures.shape.source,
  };
}
