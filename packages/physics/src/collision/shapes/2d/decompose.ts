// Concave outlines as convex pieces: triangles, of which neighbours are joined while the result is convex and has at most
// eight corners. Source: Hertel and Mehlhorn, Fast triangulation of simple polygons (1983): at most four times the
// smallest number of pieces, apart from the limit on corners.
import { PhysicsError } from '../../../errors/physics-error.ts';
import { sideOfLine } from './convex-outline.ts';
import { MAX_VERTICES } from './limits.ts';
import { polygon } from './polygon.ts';
import type { PointInput, Shape } from './shape.ts';
import { checkSimpleOutline, withoutFlatCorners } from './simple-outline.ts';
import { triangulate } from './triangulate.ts';

/** A convex piece of an outline, where its corners were given: for `parts` of `spawnCompound`. */
export interface ConvexPiece {
  readonly shape: Shape;
  /** Position of its centroid in the coordinates of the outline, m. */
  readonly x: number;
  readonly y: number;
}

/**
 * Divides the outline of a polygon of any form, in either direction around, into convex pieces: give them to
 * `spawnCompound` as `parts: decompose(points).map((piece) => ({ ...piece, density: 500 }))`. Corners on a line through
 * their neighbours are left out.
 * @param points corners in order around the outline, m; 3 to 2000
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE for outlines that cross or touch themselves, have no area or
 *   neighbours closer than 1e-5 m, or reach beyond 1e6 m
 */
export function decompose(points: readonly PointInput[]): ConvexPiece[] {
  const outline = checkSimpleOutline(points, 'decompose');
  const triangles = triangulate(outline);
  if (triangles === undefined) {
    throw new PhysicsError('E_RANGE', 'decompose: the outline is too thin to be divided.', {
      field: 'decompose: points',
      hint: 'Leave out corners where the outline nearly touches itself.',
    });
  }
  return joinPieces(outline, triangles).flatMap((corners) => {
    const piece = withoutFlatCorners(corners.flatMap((i) => [outline[i], outline[i + 1]]));
    if (piece.length < 6) return [];
    const vertices = Array.from({ length: piece.length / 2 }, (_, i) => ({ x: piece[2 * i], y: piece[2 * i + 1] }));
    const shape = polygon(vertices);
    return [{ shape, x: shape.centre.x, y: shape.centre.y }];
  });
}

/** Corners of a piece, as indices of their x, anticlockwise; empty once it has become part of another. */
type Piece = number[];

function joinPieces(outline: readonly number[], triangles: readonly (readonly number[])[]): Piece[] {
  const pieces: Piece[] = triangles.map((triangle) => [...triangle]);
  /** The piece to the left of each directed edge. */
  const left = new Map<string, Piece>();
  const takeEdges = (piece: Piece) => {
    for (const [i, from] of piece.entries()) left.set(`${from} ${piece[(i + 1) % piece.length]}`, piece);
  };
  for (const piece of pieces) takeEdges(piece);
  // The last triangle was not cut off but left.
  for (const [a, , c] of triangles.slice(0, -1)) {
    const [one, other] = [left.get(`${c} ${a}`), left.get(`${a} ${c}`)];
    if (one === undefined || other === undefined || one === other) continue;
    const joined = joinAt(one, other, c, a);
    if (joined.length > MAX_VERTICES || !isConvexAt(outline, joined, a) || !isConvexAt(outline, joined, c)) continue;
    one.splice(0, one.length, ...joined);
    other.length = 0;
    takeEdges(one);
  }
  return pieces.filter((piece) => piece.length > 0);
}

/** The outline of two pieces that share the edge between two corners, which runs from `from` to `to` in the first. */
function joinAt(one: Piece, other: Piece, from: number, to: number): Piece {
  const start = one.indexOf(to);
  const first = [...one.slice(start), ...one.slice(0, start)];
  const second = other.indexOf(from);
  const rest = [...other.slice(second), ...other.slice(0, second)];
  return [...first, ...rest.slice(1, -1)];
}

function isConvexAt(outline: readonly number[], piece: Piece, corner: number): boolean {
  const { length } = piece;
  const at = piece.indexOf(corner);
  return sideOfLine(outline, piece[(at + length - 1) % length], corner, piece[(at + 1) % length]) >= 0;
}
