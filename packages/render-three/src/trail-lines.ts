import {
  checkAlpha,
  checkOptions,
  type OptionNames,
  sourceOf,
  TrailHistory,
  type TrailOptions,
} from '@principia/render-core';
import { Group, type Object3D } from 'three';
import { assertLive } from './assert-live.ts';
import { trailSegments } from './shaders/trail-segments.ts';
import { type TrailColors, TrailTextures } from './trail-textures.ts';
import { createWideLineMesh } from './wide-line-mesh.ts';

/** Options of `createTrailLines`. */
export interface TrailLinesOptions extends TrailOptions, TrailColors {
  /** Width in CSS pixels; default 1.5. */
  width?: number;
  /** Opacity of a trail at the body, 0 to 1, fading to zero at its end; default 0.8. */
  opacity?: number;
  /**
   * Longest distance between two points that is still a movement, metres; a body that went further was teleported, and
   * its trail has a gap there. Default: no limit.
   */
  maxSegment?: number;
}

/** The latest paths of bodies as fading lines. */
export interface TrailLines {
  /** Add it to the scene. */
  readonly object: Object3D;
  /** The points; `history.restart(id)` restarts a trail after a teleport. */
  readonly history: TrailHistory;
  /**
   * Call once a frame before rendering: notes the source's pose if it moved. A frame of several steps adds one point; for
   * one of each step call it after each, as in `createRunner(world, { afterStep })`.
   *
   * @param alpha blend of previous and present step that the bodies are drawn with, so that the line meets its body
   * @throws Error when it is no number, or the lines were destroyed
   */
  update(alpha: number): void;
  /** Frees the GPU's memory; remove `object` from the scene yourself. */
  destroy(): void;
}

/** Most devices support this many layers of an array texture (WebGL 2 guarantees 256). */
const MAX_LENGTH = 2048;

const OPTION_NAMES: OptionNames<TrailLinesOptions> = {
  source: true,
  length: true,
  bodies: true,
  interval: true,
  origin: true,
  color: true,
  defaultColor: true,
  width: true,
  opacity: true,
  maxSegment: true,
};

/**
 * Draws the trails of bodies from a ring of past positions on the GPU: a step sends one slice, whatever the length.
 *
 * @throws Error when there is no source, `length` is below 2 or above 2048, `bodies` names an id outside the source, or another
 * option is out of range or does not exist
 */
export function createTrailLines(options: TrailLinesOptions): TrailLines {
  const source = sourceOf(options, 'createTrailLines');
  checkOptions(options, OPTION_NAMES, 'createTrailLines');
  const { width = 1.5, opacity = 0.8, maxSegment = Number.POSITIVE_INFINITY } = options;
  if (options.length > MAX_LENGTH) {
    throw new Error(`trails can have at most ${MAX_LENGTH} points, got ${options.length}: raise interval instead`);
  }
  if (!(opacity >= 0 && opacity <= 1)) throw new Error(`opacity must be a number from 0 to 1, got ${opacity}`);
  if (!(maxSegment > 0)) throw new Error(`maxSegment must be a distance above zero, got ${maxSegment}`);
  const history = new TrailHistory(options);
  const textures = new TrailTextures(history, options);
  const { uniforms } = textures;
  uniforms.opacity = { value: opacity };
  // Shaders need not know infinity.
  uniforms.maxSegment = { value: Math.min(maxSegment, 1e30) };
  const segmentEnds = trailSegments(source.dimensions, history.interval > 1);
  const line = createWideLineMesh(segmentEnds, uniforms, width, (renderer) => textures.beforeDrawing(renderer));
  const object = new Group().add(line.mesh);
  let poseVersion = Number.NaN;
  let live = true;
  return {
    object,
    history,
    update(alpha) {
      assertLive(live, 'createTrailLines');
      checkAlpha(alpha);
      if (source.versions.pose !== poseVersion) {
        poseVersion = source.versions.pose;
        history.record();
      }
      textures.refresh(alpha);
      line.mesh.position.copy(history.origin);
      line.setCount(history.count * (history.length - 1));
    },
    destroy() {
      live = false;
      line.destroy();
      textures.dispose();
    },
  };
}
