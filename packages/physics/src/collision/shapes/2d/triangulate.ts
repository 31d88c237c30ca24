// Triangulation of a simple polygon by ear clipping: O(n²). Of all ears the one whose smallest angle is the largest is cut
// first, so that few triangles are thin. Source: Meisters, Polygons have ears (1975); Eberly, Triangulation by ear clipping (2002).
import { turn } from './simple-outline.ts';

/** Three corners, given as indices of their x, anticlockwise. */
export type Triangle = readonly [number, number, number];

/** Returns the triangles of an outline, anticlockwise, in the order in which they were cut; undefined if there is no ear. */
export function triangulate(outline: readonly number[]): Triangle[] | undefined {
  const corners = Array.from({ length: outline.length / 2 }, (_, i) => 2 * i);
  const quality = corners.map((_, at) => qualityOf(outline, corners, at));
  const triangles: Triangle[] = [];
  while (corners.length > 3) {
    const best = quality.reduce((found, value, i) => (value > quality[found] ? i : found), 0);
    if (!(quality[best] > 0)) return undefined;
    triangles.push(around(corners, best));
    corners.splice(best, 1);
    quality.splice(best, 1);
    const { length } = corners;
    for (const at of [best % length, (best + length - 1) % length]) quality[at] = qualityOf(outline, corners, at);
  }
  triangles.push([corners[0], corners[1], corners[2]]);
  return triangles;
}

function around(corners: readonly number[], at: number): Triangle {
  const { length } = corners;
  return [corners[(at + length - 1) % length], corners[at], corners[(at + 1) % length]];
}

/** 0 for a corner that is no ear; otherwise twice the area by the square of the longest side. */
function qualityOf(p: readonly number[], corners: readonly number[], at: number): number {
  const [a, b, c] = around(corners, at);
  const area = turn(p, a, b, c);
  if (!(area > 0)) return 0;
  for (const other of corners) {
    if (other === a || other === b || other === c) continue;
    // A corner on the new edge would be cut off from the outline.
    if (turn(p, a, b, other) >= 0 && turn(p, b, c, other) >= 0 && turn(p, c, a, other) >= 0) return 0;
  }
  const square = (i: number, j: number) =>
    (p[i] - p[j]) * (p[i] - p[j]) + (p[i + 1] - p[j + 1]) * (p[i + 1] - p[j + 1]);
  return area / Math.max(square(a, b), square(b, c), square(c, a));
}
