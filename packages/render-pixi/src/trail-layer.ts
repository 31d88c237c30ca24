import { type BodySource, checkOptions, type OptionNames, sourceOf, TrailHistory } from '@principia/render-core';
import type { Container } from 'pixi.js';
import { addTrails } from './boxes.ts';
import { writeColor } from './color.ts';
import { checkThickness, lineReach } from './line-style.ts';
import { PullMesh } from './pull-mesh.ts';
import { TRAIL_PROGRAM } from './shaders/trail-program.ts';
import { SourceTextures } from './source-textures.ts';
import { TrailTextures } from './trail-textures.ts';

/** How a trail layer draws. */
export interface TrailLayerOptions {
  /** The bodies, by `worldSource`. */
  source: BodySource;
  /** Points per trail, at least 2; default 32. */
  length?: number;
  /**
   * Ids of the bodies that leave trails, fixed for the life of the layer. A trail ends with its body: another one that takes
   * the id has none. Default all, where bodies × points must fit into a texture: 8 388 608 in all.
   */
  bodies?: ArrayLike<number>;
  /** Record every n-th pose; default 1. */
  interval?: number;
  /** Width at the body, CSS pixels; default 2. Trails taper to a third of it. */
  thickness?: number;
  /** Colour of all trails as 0xRRGGBB; default: each body's own colour. */
  color?: number;
  /** Colour of trails of bodies whose colour is 0; default 0x4f9dde. */
  defaultColor?: number;
  /** Opacity at the body; trails fade to nothing. Default 0.7. */
  opacity?: number;
  /**
   * Longest distance between two points that is still a movement, metres; a body that went further was teleported, and
   * its trail has a gap there. Default: no limit.
   */
  maxSegment?: number;
  /** Pixels of the layer's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
  /** `add` lets overlapping trails brighten each other; default `normal`. */
  blendMode?: 'normal' | 'add';
}

/** Trails behind the bodies of a world, to be added to a pixi stage below the bodies. */
export interface TrailLayer {
  /** Add it anywhere, as that of a body layer. */
  readonly container: Container;
  /** The recorded points; `history.clear()` and `history.restart(id)` start trails afresh. */
  readonly history: TrailHistory;
  /** Records the pose if it is new, and brings the picture up to date; call it once a frame, as for bodies. */
  update(alpha: number): void;
  /** Frees the layer's own resources and takes it off its parent. */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<TrailLayerOptions> = {
  source: true,
  length: true,
  bodies: true,
  interval: true,
  thickness: true,
  color: true,
  defaultColor: true,
  opacity: true,
  maxSegment: true,
  pixelsPerMetre: true,
  blendMode: true,
};

/**
 * Draws a fading line through the last positions of each body. A step uploads one position per body, and the GPU builds
 * the lines, so trails cost the processor about as much as the bodies themselves.
 *
 * @throws Error when there is no source, an option is out of range or does not exist, or the trails do not fit into a texture
 */
export function createTrailLayer(options: TrailLayerOptions): TrailLayer {
  const source = sourceOf(options, 'createTrailLayer');
  checkOptions(options, OPTION_NAMES, 'createTrailLayer');
  const { length = 32, bodies, interval = 1, pixelsPerMetre = 1, blendMode = 'normal' } = options;
  const history = new TrailHistory({ source, length, interval, ...(bodies === undefined ? {} : { bodies }) });
  const trails = new TrailTextures(history);
  const textures = SourceTextures.acquire(source);
  const bound = bindings(textures, trails, bodies !== undefined);
  const { thickness = 2 } = options;
  const mesh = new PullMesh(TRAIL_PROGRAM, bound, pixelsPerMetre, blendMode, (box, pixel) =>
    addTrails(box, history, lineReach(thickness, pixel)),
  );
  setStyle(mesh, options);
  mesh.uniforms.uLength = length;
  mesh.uniforms.uSliceTexels = history.birth.length;
  mesh.uniforms.uIndirect = bodies === undefined ? 0 : 1;
  let pose = Number.NaN;
  let live = true;

  return {
    container: mesh.container,
    history,
    update(alpha) {
      mesh.assertDrawable();
      if (bodies === undefined) textures.syncIds();
      textures.syncPosition();
      textures.syncStyle();
      const { originX, originY } = textures;
      if (originX !== history.origin.x || originY !== history.origin.y) history.setOrigin(originX, originY);
      if (source.versions.pose !== pose) {
        pose = source.versions.pose;
        if (history.record()) trails.recorded();
      }
      trails.sync();
      mesh.uniforms.uAlpha = textures.alphaOf(alpha);
      mesh.uniforms.uNewestSlice = history.newestSlice;
      mesh.uniforms.uRecordings = history.recordings;
      mesh.uniforms.uSkip = history.newestIsCurrent ? 1 : 0;
      mesh.place(originX, originY);
      // Before there is a second point no program is made for what cannot be seen.
      const points = history.recordings - (history.newestIsCurrent ? 1 : 0);
      mesh.draw(points > 0 ? history.count : 0, length - 1);
    },
    destroy() {
      if (!live) return;
      live = false;
      mesh.destroy();
      trails.destroy();
      textures.release();
    },
  };
}

function setStyle(mesh: PullMesh, options: TrailLayerOptions): void {
  const {
    thickness = 2,
    color,
    defaultColor = 0x4f9dde,
    opacity = 0.7,
    maxSegment = Number.POSITIVE_INFINITY,
  } = options;
  const rgba = new Float32Array(4);
  writeColor(rgba, color ?? defaultColor);
  checkThickness(thickness);
  if (!(opacity >= 0 && opacity <= 1)) throw new Error(`opacity must be a number from 0 to 1, got ${opacity}`);
  if (!(maxSegment > 0)) throw new Error(`maxSegment must be a distance above zero, got ${maxSegment}`);
  mesh.uniforms.uTrailColor = rgba;
  mesh.uniforms.uOwnColor = color === undefined ? 0 : 1;
  mesh.uniforms.uThickness = thickness;
  mesh.uniforms.uOpacity = opacity;
  // Shaders need not know infinity.
  mesh.uniforms.uMaxSegment = Math.min(maxSegment, 1e30);
}

function bindings(textures: SourceTextures, trails: TrailTextures, chosen: boolean) {
  return {
    uSlots: chosen ? trails.slots.source : textures.ids.source,
    uBodies: trails.bodies.source,
    uX: textures.x.texture.source,
    uY: textures.y.texture.source,
    uPreviousX: textures.previousX.texture.source,
    uPreviousY: textures.previousY.texture.source,
    uBodyColor: textures.color.source,
    uHistoryX: trails.x,
    uHistoryY: trails.y,
    uBirth: trails.birth.source,
  };
}
