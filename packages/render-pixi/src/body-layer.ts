import { type BodySource, checkOptions, type OptionNames, sourceOf } from '@principia/render-core';
import type { Container } from 'pixi.js';
import { addBodies } from './boxes.ts';
import { writeColor } from './color.ts';
import { ColumnTexture } from './column-texture.ts';
import { PullMesh } from './pull-mesh.ts';
import { BODY_PROGRAM } from './shaders/body-program.ts';
import { SourceTextures } from './source-textures.ts';

/** Options of a body layer. */
export interface BodyLayerOptions {
  /** The bodies, by `worldSource`. */
  source: BodySource;
  /** Pixels of the layer's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
  /** Colour of bodies whose colour is 0, as 0xRRGGBB; default 0x4f9dde. */
  defaultColor?: number;
  /** `add` lets overlapping bodies brighten each other, as fire and stars do; default `normal`. */
  blendMode?: 'normal' | 'add';
  /** Smallest drawn radius of bodies that have a size or a collider, physical pixels; default 0.5. */
  minimumPixels?: number;
  /** Width of a darker rim of filled shapes, not of rings and glows, CSS pixels; default 0. */
  rimWidth?: number;
  /** False ignores the angles of boxes, marked discs and colliders. Default true. */
  rotation?: boolean;
}

/** Bodies of a world, to be added to a pixi stage. */
export interface BodyLayer {
  /**
   * Add it anywhere, also under filters and masks. Its coordinates are metres times `pixelsPerMetre`, with y up. `getBounds`
   * passes over all bodies.
   */
  readonly container: Container;
  /**
   * Updates the picture; call it once a frame before rendering. Uploads the data that changed since the last call,
   * without garbage.
   *
   * @param alpha position between the previous (0) and the present pose (1)
   * @throws Error when the layer was destroyed
   */
  update(alpha: number): void;
  /**
   * Sets the world point, metres, near which an f64 source is drawn precisely; move it with the camera in a world too
   * large for f32. No effect for an f32 source. Applies to every layer of the same source. The camera must then be applied to a
   * container of your own and not to the stage, see `applyCamera`.
   */
  setOrigin(x: number, y: number): void;
  /** Frees the layer's resources and removes it from its parent. */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<BodyLayerOptions> = {
  source: true,
  pixelsPerMetre: true,
  defaultColor: true,
  blendMode: true,
  minimumPixels: true,
  rimWidth: true,
  rotation: true,
};

/**
 * Draws every body of a source as the shape of its collider, or as a disc, ring, box, marked disc or glow; those with neither a
 * size nor a collider are not drawn. The GPU reads the world's columns by entity
 * id, so the cost in JavaScript is one upload per changed column, independent of the number of bodies.
 *
 * @throws Error when there is no source, or an option is out of range or does not exist; the first `update` also where the source's
 * rows are not a multiple of 1024
 */
export function createBodyLayer(options: BodyLayerOptions): BodyLayer {
  const source = sourceOf(options, 'createBodyLayer');
  checkOptions(options, OPTION_NAMES, 'createBodyLayer');
  const { pixelsPerMetre = 1, defaultColor = 0x4f9dde, blendMode = 'normal' } = options;
  const { minimumPixels = 0.5, rotation = true, rimWidth = 0 } = options;
  const color = new Float32Array(4);
  writeColor(color, defaultColor);
  if (!(minimumPixels > 0)) throw new Error(`minimumPixels must be above zero, got ${minimumPixels}`);
  if (!(rimWidth >= 0)) throw new Error(`rimWidth must be zero or more, got ${rimWidth}`);
  const textures = SourceTextures.acquire(source);
  // The angles of the source may be on the GPU for another layer. Rows beyond those of a texture are read as zeros.
  const unturned = rotation ? undefined : new ColumnTexture('real');
  const mesh = new PullMesh(BODY_PROGRAM, bindings(textures, unturned), pixelsPerMetre, blendMode, (box, pixel) =>
    addBodies(box, source, textures, minimumPixels * pixel, pixel),
  );
  mesh.uniforms.uDefaultColor = color;
  mesh.uniforms.uMinimumPixels = minimumPixels;
  mesh.uniforms.uRim = rimWidth;
  let live = true;

  return {
    container: mesh.container,
    update(alpha) {
      mesh.assertDrawable();
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
      unturned?.destroy();
      textures.release();
    },
  };
}

/** @param unturned angles in place of those of the source */
function bindings(textures: SourceTextures, unturned: ColumnTexture | undefined) {
  return {
    uIds: textures.ids.source,
    uX: textures.x.texture.source,
    uY: textures.y.texture.source,
    uPreviousX: textures.previousX.texture.source,
    uPreviousY: textures.previousY.texture.source,
    uAngle: (unturned ?? textures.angle.texture).source,
    uPreviousAngle: (unturned ?? textures.previousAngle.texture).source,
    uRadius: textures.radius.texture.source,
    uSize: textures.size.texture.source,
    uBodyColor: textures.color.source,
    uShape: textures.shape.source,
    uOutline: textures.outline.source,
    uOutlines: textures.outlines.source,
  };
}
