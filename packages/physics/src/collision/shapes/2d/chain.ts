import { PhysicsError } from '../../../errors/physics-error.ts';
import { checkFlag, checkKeys, mustBe } from '../../../errors/validate.ts';
import { checkPoint } from './convex-outline.ts';
import { MIN_LENGTH } from './limits.ts';
import { makeShape } from './make-shape.ts';
import { lengthOf, type PointInput, type Shape } from './shape.ts';

/** Options of `chain`. */
export interface ChainOptions {
  /** Whether a last segment leads back to the first point. Default false. */
  readonly closed?: boolean;
}

/**
 * A line of segments that bodies meet from the right of its direction only: a floor leads from right to left, and bodies fall through
 * one from left to right; an outline of something solid goes round anticlockwise. Bodies slide along it as along one
 * surface, and do not catch on the points between. A chain that is not closed has no ends to catch on either.
 * @param points m, of any number
 * @returns one shape for each segment; its body belongs at the shape's `centre`, as `spawnChain` puts it
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE for fewer than two points (three of a closed chain),
 *   coordinates beyond 1e6 m and neighbours closer than 1e-5 m
 */
export function chain(points: readonly PointInput[], options: ChainOptions = {}): Shape[] {
  checkKeys(options, 'chain', ['closed']);
  const isClosed = checkFlag(options.closed, 'chain: closed');
  if (!Array.isArray(points)) throw mustBe('an array of { x, y }', points, 'chain: points');
  const least = isClosed ? 3 : 2;
  if (points.length < least) {
    throw new PhysicsError('E_RANGE', `chain: points has ${points.length} points.`, {
      field: 'chain: points',
      value: points.length,
      hint: `A chain has at least two, a closed one three.`,
    });
  }
  const line = points.map((point: PointInput, i) => checkPoint(point, `chain: points[${i}]`));
  const count = isClosed ? line.length : line.length - 1;
  const at = (i: number) => (isClosed ? line[(i + line.length) % line.length] : line[i]);
  for (let i = 0; i < count; i++) checkGap(at(i), at(i + 1), i);
  return Array.from({ length: count }, (_, i) => {
    const [start, end] = [at(i), at(i + 1)];
    // Beyond its ends an open chain seems to go straight on.
    const before = at(i - 1) ?? beyond(end, start);
    const after = at(i + 2) ?? beyond(start, end);
    return makeShape('segment', [start.x, start.y, end.x, end.y], 0, [before.x, before.y, after.x, after.y]);
  });
}

interface Point {
  readonly x: number;
  readonly y: number;
}

function checkGap(a: Point, b: Point, index: number): void {
  const gap = lengthOf(b.x - a.x, b.y - a.y);
  if (gap >= MIN_LENGTH) return;
  throw new PhysicsError('E_RANGE', `chain: points ${index} and ${index + 1} are ${gap} m apart.`, {
    field: `chain: points[${index}]`,
    value: gap,
    hint: `Neighbours must be at least ${MIN_LENGTH} m apart: leave one of the two out.`,
  });
}

function beyond(from: Point, to: Point): Point {
  return { x: 2 * to.x - from.x, y: 2 * to.y - from.y };
}
