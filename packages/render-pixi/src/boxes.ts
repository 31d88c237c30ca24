import { type BodySource, SHAPES, TEXTURE_WIDTH, type TrailHistory } from '@principia/render-core';
import type { Bounds } from 'pixi.js';

/** A box that grows, metres from an origin, as a `Bounds` of pixi. */
export type Box = Pick<Bounds, 'minX' | 'minY' | 'maxX' | 'maxY'>;

/** Zero of the coordinates of a box, metres. */
export interface Origin {
  readonly originX: number;
  readonly originY: number;
}

/**
 * Extends a box by all bodies that are drawn, wherever between the last two steps.
 *
 * @param least smallest drawn radius, metres
 * @param margin width of the soft edges, metres
 */
export function addBodies(box: Box, source: BodySource, origin: Origin, least: number, margin: number): void {
  const { ids, count, radius, size, shape } = source;
  for (let i = 0; i < count; i++) {
    const id = ids[i];
    const drawn = size[id] > 0 ? size[id] : radius[id];
    if (!(drawn > 0)) continue;
    const reach = Math.max(drawn, least) + margin;
    // The corners of a square are farther away than its sides.
    addPlaces(box, source, id, origin, shape[id] === SHAPES.box ? Math.SQRT2 * reach : reach);
  }
}

/** Extends a box by the squares of half-width `reach`, metres, around the last two places of a body. */
export function addPlaces(box: Box, source: BodySource, id: number, { originX, originY }: Origin, reach: number): void {
  const { position, previousPosition } = source;
  addPoint(box, position.x[id] - originX, position.y[id] - originY, reach);
  addPoint(box, previousPosition.x[id] - originX, previousPosition.y[id] - originY, reach);
}

/** Extends a box by the points of all trails, from the origin of the history. @param reach half of their width, metres */
export function addTrails(box: Box, history: TrailHistory, reach: number): void {
  const { source, bodies, count, birth, recordings, length, rowsPerSlice, x, y, origin } = history;
  const from = { originX: origin.x, originY: origin.y };
  for (let i = 0; i < count; i++) {
    const slot = bodies === undefined ? source.ids[i] : i;
    const oldest = Math.max(birth[slot], recordings - length);
    if (oldest < recordings) addPlaces(box, source, bodies?.[i] ?? slot, from, reach);
    for (let n = oldest; n < recordings; n++) {
      const at = (n % length) * rowsPerSlice * TEXTURE_WIDTH + slot;
      addPoint(box, x[at], y[at], reach);
    }
  }
}

/** Extends a box by the square of half-width `reach` around a point. */
export function addPoint(box: Box, x: number, y: number, reach: number): void {
  if (x - reach < box.minX) box.minX = x - reach;
  if (y - reach < box.minY) box.minY = y - reach;
  if (x + reach > box.maxX) box.maxX = x + reach;
  if (y + reach > box.maxY) box.maxY = y + reach;
}
