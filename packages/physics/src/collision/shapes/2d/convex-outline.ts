// Checks that points are the outline of a convex polygon.
import { PhysicsError } from '../../../errors/physics-error.ts';
import { checkVector, mustBe } from '../../../errors/validate.ts';
import { COORDINATE, MAX_VERTICES, MIN_LENGTH } from './limits.ts';
import { lengthOf, type PointInput } from './shape.ts';

/**
 * Least distance of a corner from the line through its neighbours, as a fraction of their distance: flatter corners
 * would be lost when coordinates are rounded to f32.
 */
const MIN_CORNER = 1e-5;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE */
export function checkPoint(value: unknown, field: string): { x: number; y: number } {
  const { x, y, z } = checkVector(value, field, COORDINATE);
  if (z !== 0) throw mustBe('0 for a shape of two dimensions', z, `${field}.z`, 'E_RANGE');
  return { x, y };
}

/**
 * Returns the outline as x and y of each corner, anticlockwise; a clockwise one is reversed.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE
 */
export function checkOutline(points: unknown, caller: string): number[] {
  const field = `${caller}: points`;
  if (!Array.isArray(points)) throw mustBe('an array of { x, y }', points, field);
  if (points.length < 3 || points.length > MAX_VERTICES) {
    throw new PhysicsError('E_RANGE', `${field} has ${points.length} corners.`, {
      field,
      value: points.length,
      hint: `A polygon has 3 to ${MAX_VERTICES}: divide a larger outline by decompose(points).`,
    });
  }
  const corners = points.map((point: PointInput, i) => checkPoint(point, `${field}[${i}]`));
  const outline = corners.flatMap(({ x, y }) => [x, y]);
  checkEdges(outline, field);
  const ordered = signedArea(outline) < 0 ? [...corners].reverse().flatMap(({ x, y }) => [x, y]) : outline;
  checkConvex(ordered, field, ordered === outline);
  return ordered;
}

/** @throws PhysicsError E_RANGE for neighbours that are too close */
export function checkEdges(outline: readonly number[], field: string): void {
  const { length } = outline;
  for (let i = 0; i < length; i += 2) {
    const next = (i + 2) % length;
    const edge = lengthOf(outline[next] - outline[i], outline[next + 1] - outline[i + 1]);
    if (edge >= MIN_LENGTH) continue;
    throw new PhysicsError('E_RANGE', `${field}: corners ${i / 2} and ${next / 2} are ${edge} m apart.`, {
      field,
      value: edge,
      hint: `Neighbours must be at least ${MIN_LENGTH} m apart: leave one of the two out.`,
    });
  }
}

/** The area within an outline, m², negative where it runs clockwise. */
export function signedArea(outline: readonly number[]): number {
  const { length } = outline;
  const [x0, y0] = outline;
  let twice = 0;
  for (let i = 2; i + 2 < length; i += 2) {
    twice += (outline[i] - x0) * (outline[i + 3] - y0) - (outline[i + 1] - y0) * (outline[i + 2] - x0);
  }
  return 0.5 * twice;
}

/**
 * Each corner must lie to the left of every edge that does not end there; this also refuses outlines that cross. The
 * turn at each corner is checked first, because a message about it is the easiest to follow.
 */
function checkConvex(outline: readonly number[], field: string, isInOrder: boolean): void {
  const count = outline.length / 2;
  const indexOf = (corner: number) => (isInOrder ? corner % count : count - 1 - (corner % count));
  for (let ahead = 2; ahead < count; ahead++) {
    for (let edge = 0; edge < count; edge++) {
      const side = sideOf(outline, edge, (edge + ahead) % count);
      if (side > 0) continue;
      const corners = [edge, edge + 1, edge + ahead].map(indexOf);
      throw outlineError(field, corners, side === 0, ahead === 2);
    }
  }
}

/** Returns 1 for a corner to the left of an edge, -1 to its right, 0 where they are too nearly in line to tell. */
function sideOf(outline: readonly number[], edge: number, corner: number): number {
  const [from, to] = [2 * edge, (2 * edge + 2) % outline.length];
  return sideOfLine(outline, from, to, 2 * corner);
}

/** As `sideOf`, for the line from one corner to another and a third, given as indices of their x. */
export function sideOfLine(outline: readonly number[], from: number, to: number, corner: number): number {
  const [dx, dy] = [outline[to] - outline[from], outline[to + 1] - outline[from + 1]];
  const [x, y] = [outline[corner] - outline[from], outline[corner + 1] - outline[from + 1]];
  const length = lengthOf(dx, dy);
  const distance = (dx * y - dy * x) / length;
  return Math.abs(distance) <= MIN_CORNER * Math.max(length, Math.abs(x), Math.abs(y)) ? 0 : Math.sign(distance);
}

function outlineError(
  field: string,
  [a, b, c]: readonly number[],
  isFlat: boolean,
  isNeighbour: boolean,
): PhysicsError {
  const turn = isNeighbour ? `it turns inward at corner ${b}` : `the edge from ${a} to ${b} cuts off corner ${c}`;
  const problem = isFlat ? `corners ${a}, ${b} and ${c} lie on one line` : `the outline is not convex: ${turn}`;
  const hint = isFlat
    ? 'Leave the one in the middle out.'
    : 'Give the corners in order around a convex outline, or divide a concave one by decompose(points).';
  return new PhysicsError('E_RANGE', `${field}: ${problem}.`, { field, hint });
}
