// Checks that points are the outline of a polygon that does not cross or touch itself, convex or not.
import { PhysicsError } from '../../../errors/physics-error.ts';
import { mustBe } from '../../../errors/validate.ts';
import { checkEdges, checkPoint, sideOfLine, signedArea } from './convex-outline.ts';
import type { PointInput } from './shape.ts';

/** All pairs of edges are compared. */
const MAX_CORNERS = 2000;

/**
 * Returns the outline as x and y of each corner, anticlockwise, without the corners in the middle of a line.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN; E_RANGE for fewer than three corners or more than 2000, neighbours
 *   closer than 1e-5 m, and outlines that cross or touch themselves or have no area
 */
export function checkSimpleOutline(points: unknown, caller: string): number[] {
  const field = `${caller}: points`;
  if (!Array.isArray(points)) throw mustBe('an array of { x, y }', points, field);
  if (points.length < 3 || points.length > MAX_CORNERS) {
    throw new PhysicsError('E_RANGE', `${field} has ${points.length} corners.`, {
      field,
      value: points.length,
      hint: `An outline has 3 to ${MAX_CORNERS}.`,
    });
  }
  const outline = points.flatMap((point: PointInput, i) => {
    const { x, y } = checkPoint(point, `${field}[${i}]`);
    return [x, y];
  });
  checkEdges(outline, field);
  checkCrossings(outline, field);
  const straight = withoutFlatCorners(signedArea(outline) < 0 ? reversed(outline) : outline);
  if (straight.length >= 6) return straight;
  throw new PhysicsError('E_RANGE', `${field}: all corners lie on one line.`, {
    field,
    hint: 'For a line use segment.',
  });
}

function reversed(outline: readonly number[]): number[] {
  return Array.from(outline, (_, i) => outline[outline.length - 2 - i + 2 * (i % 2)]);
}

/** Leaves out each corner that lies on the line through its neighbours. */
export function withoutFlatCorners(outline: readonly number[]): number[] {
  let kept = [...outline];
  for (let i = 0; i < kept.length && kept.length >= 6; ) {
    const { length } = kept;
    const isFlat = sideOfLine(kept, (i + length - 2) % length, (i + 2) % length, i) === 0;
    if (isFlat) kept = [...kept.slice(0, i), ...kept.slice(i + 2)];
    else i += 2;
  }
  return kept.length >= 6 ? kept : [];
}

function checkCrossings(outline: readonly number[], field: string): void {
  const count = outline.length / 2;
  for (let i = 0; i < count; i++) {
    if (foldsBack(outline, i)) throw crossing(field, `it turns back on itself at corner ${i}`, i);
  }
  for (let i = 0; i < count; i++) {
    for (let j = i + 2; j < count; j++) {
      const areNeighbours = i === 0 && j === count - 1;
      if (!areNeighbours && meet(outline, i, j)) {
        const [a, b] = [`${i} to ${i + 1}`, `${j} to ${(j + 1) % count}`];
        throw crossing(field, `the edge from corner ${a} meets that from ${b}`, i);
      }
    }
  }
}

function crossing(field: string, problem: string, value: number): PhysicsError {
  return new PhysicsError('E_RANGE', `${field}: ${problem}.`, {
    field,
    value,
    hint: 'Give the corners in order around an outline that neither crosses nor touches itself.',
  });
}

function foldsBack(outline: readonly number[], corner: number): boolean {
  const { length } = outline;
  const [at, before, after] = [2 * corner, (2 * corner + length - 2) % length, (2 * corner + 2) % length];
  const [ax, ay] = [outline[before] - outline[at], outline[before + 1] - outline[at + 1]];
  const [bx, by] = [outline[after] - outline[at], outline[after + 1] - outline[at + 1]];
  return ax * by - ay * bx === 0 && ax * bx + ay * by > 0;
}

/** Whether two edges have a point in common. */
function meet(outline: readonly number[], i: number, j: number): boolean {
  const { length } = outline;
  const [a, b, c, d] = [2 * i, (2 * i + 2) % length, 2 * j, (2 * j + 2) % length];
  if (!boxesOverlap(outline, a, b, c, d)) return false;
  const [abc, abd] = [turn(outline, a, b, c), turn(outline, a, b, d)];
  const [cda, cdb] = [turn(outline, c, d, a), turn(outline, c, d, b)];
  // Edges on one line have a point in common where their boxes do.
  return abc * abd <= 0 && cda * cdb <= 0;
}

function boxesOverlap(p: readonly number[], a: number, b: number, c: number, d: number): boolean {
  for (const axis of [0, 1]) {
    if (Math.max(p[a + axis], p[b + axis]) < Math.min(p[c + axis], p[d + axis])) return false;
    if (Math.max(p[c + axis], p[d + axis]) < Math.min(p[a + axis], p[b + axis])) return false;
  }
  return true;
}

/** Twice the area of the triangle of three corners, given as indices of their x: positive where it runs anticlockwise. */
export function turn(p: readonly number[], a: number, b: number, c: number): number {
  return (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a]);
}
