import { type BodySource, checkOptions, type OptionNames, sourceOf } from '@principia/render-core';
import type { Container } from 'pixi.js';
import { addPlaces } from './boxes.ts';
import { ColumnTexture } from './column-texture.ts';
import { LineColors } from './line-colors.ts';
import { applyLineStyle, checkLength, type LineStyle, lineCount, lineReach } from './line-style.ts';
import { LinkList, NO_LINK } from './link-list.ts';
import { PullMesh } from './pull-mesh.ts';
import { LINK_PROGRAM } from './shaders/link-program.ts';
import { SourceTextures } from './source-textures.ts';

/** Options of a link layer. */
export interface LinkLayerOptions extends LineStyle {
  /** The bodies, by `worldSource`. */
  source: BodySource;
}

/** Lines between the centres of bodies: springs, ropes, cloth, constellations. */
export interface LinkLayer {
  /** Add it anywhere, as that of a body layer. */
  readonly container: Container;
  /**
   * Replaces the links; needed only when they change, since the lines follow the bodies. A link whose body is removed is
   * not drawn any more, nor to another body that takes the id.
   *
   * @param pairs ids of the two bodies of each link, one pair after the other
   * @param count number of links; default: all in the array
   * @param colors colour of each link as RGBA bytes in memory order (`0xAABBGGRR`), zero for the layer's colour
   * @throws Error when an array is shorter than `count` links need, `pairs` ends within a link, an id is none of the source, or
   * `count` not a whole number from zero; the links then stay as they are
   */
  set(pairs: ArrayLike<number>, count?: number, colors?: ArrayLike<number>): void;
  /** Updates the picture; call it once a frame, as for bodies. */
  update(alpha: number): void;
  /** Frees the layer's resources and removes it from its parent. */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<LinkLayerOptions> = {
  source: true,
  thickness: true,
  color: true,
  opacity: true,
  blendMode: true,
  pixelsPerMetre: true,
};

/**
 * Creates an empty layer of links between bodies of `source`.
 * @throws Error when there is no source, or an option is out of range or does not exist
 */
export function createLinkLayer(options: LinkLayerOptions): LinkLayer {
  const source = sourceOf(options, 'createLinkLayer');
  checkOptions(options, OPTION_NAMES, 'createLinkLayer');
  const { pixelsPerMetre = 1, blendMode = 'normal' } = options;
  const textures = SourceTextures.acquire(source);
  const pairsTexture = new ColumnTexture('whole');
  const colors = new LineColors();
  const bindings = {
    uPairs: pairsTexture.source,
    uLineColors: colors.texture.source,
    uX: textures.x.texture.source,
    uY: textures.y.texture.source,
    uPreviousX: textures.previousX.texture.source,
    uPreviousY: textures.previousY.texture.source,
  };
  const links = new LinkList(source);
  const mesh = new PullMesh(LINK_PROGRAM, bindings, pixelsPerMetre, blendMode, (box, pixel) => {
    for (let i = 0; i < 2 * links.count; i++) {
      const id = links.shown[i];
      if (id !== NO_LINK) addPlaces(box, source, id, textures, lineReach(options.thickness, pixel));
    }
  });
  applyLineStyle(mesh, options);
  let live = true;

  return {
    container: mesh.container,
    set(pairs, wanted, linkColors) {
      mesh.assertDrawable();
      const count = lineCount('pairs', pairs, 2, wanted);
      if (linkColors !== undefined) checkLength('colors', linkColors, count);
      links.set(pairs, count);
      pairsTexture.upload(links.shown, 2 * count);
      colors.set(count, linkColors);
      mesh.draw(count);
    },
    update(alpha) {
      mesh.assertDrawable();
      if (links.refresh()) pairsTexture.upload(links.shown, 2 * links.count);
      textures.syncPosition();
      mesh.uniforms.uAlpha = textures.alphaOf(alpha);
      mesh.place(textures.originX, textures.originY);
    },
    destroy() {
      if (!live) return;
      live = false;
      mesh.destroy();
      pairsTexture.destroy();
      colors.texture.destroy();
      textures.release();
    },
  };
}
