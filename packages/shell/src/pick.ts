import type { BodySource } from '@principia/render-core';

/**
 * Finds the body of a 2D world under a point: among the bodies that contain the point, the one drawn last; otherwise
 * the body with the nearest rim within `slack`.
 *
 * @param alpha position of the picture between the previous (0) and the present step (1)
 * @param slack tolerance in metres, for touch input
 * @returns the body's id, 0 if there is none
 */
export function pickBody2D(source: BodySource, alpha: number, x: number, y: number, slack: number): number {
  const { ids, count, position, previousPosition: previous, size, radius } = source;
  let found = 0;
  let nearest = slack;
  for (let slot = 0; slot < count; slot++) {
    const id = ids[slot];
    const r = size[id] || radius[id];
    const dx = previous.x[id] + (position.x[id] - previous.x[id]) * alpha - x;
    const dy = previous.y[id] + (position.y[id] - previous.y[id]) * alpha - y;
    const reach = r + nearest;
    const square = dx * dx + dy * dy;
    if (!(r > 0) || square > reach * reach) continue;
    nearest = Math.max(0, Math.sqrt(square) - r);
    found = id;
  }
  return found;
}
