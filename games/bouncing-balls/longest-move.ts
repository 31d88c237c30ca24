/** What trails take for a movement. */
import type { BouncingBalls } from '@principia/scenes';

/** A ball that goes further between two pictures, m, left the room at one side and came back at the other. */
export function longestMove({ room: { min, max } }: Pick<BouncingBalls, 'room'>): number {
  const sides = [max.x - min.x, max.y - min.y, max.z - min.z];
  return 0.5 * Math.min(...sides.filter((side) => side > 0));
}
