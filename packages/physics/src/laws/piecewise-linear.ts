// A measured curve in a law: straight lines between points.
//
//   y(x) = y₀ + Σ s_i (min(max(x, x_i), x_i+1) - x_i),   s_i the slope after point i
//
// Each term rises between its two points only, so there is neither a search nor a branch. Cost: four operations a point.
import { describe, PhysicsError } from '../errors/physics-error.ts';
import { checkList, checkNumber } from '../errors/validate.ts';
import { type Scalar, type ScalarInput, scalarOf } from './expression.ts';

/** Points (x, y) of a curve, in ascending order of x; two at least, and 64 at most. */
export type CurvePoints = readonly (readonly [x: number, y: number])[];

const MAX_POINTS = 64;

/** Validates and copies the points of a curve. @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE */
export function checkCurve(points: CurvePoints, what: string): CurvePoints {
  checkList(points ?? null, what);
  if (points.length < 2 || points.length > MAX_POINTS) {
    throw new PhysicsError('E_RANGE', `${what} has ${points.length} points; from 2 to ${MAX_POINTS} are allowed.`, {
      field: what,
    });
  }
  const checked = points.map((point, i): [number, number] => {
    checkList(point ?? null, `${what}[${i}]`);
    return [checkNumber(point[0], `${what}[${i}][0]`), checkNumber(point[1], `${what}[${i}][1]`)];
  });
  for (let i = 1; i < checked.length; i++) {
    if (checked[i][0] > checked[i - 1][0]) continue;
    throw new PhysicsError('E_RANGE', `${what}[${i}] has x = ${describe(checked[i][0])}, not above that before it.`, {
      field: `${what}[${i}]`,
      hint: 'Give the points in ascending order of x.',
    });
  }
  return checked;
}

/**
 * The value of a curve of straight lines at x; before the first and after the last point it is constant.
 * @param points (x, y) in ascending order of x, 2 to 64
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function piecewiseLinear(x: ScalarInput, points: CurvePoints): Scalar {
  const at = scalarOf(x, 'piecewiseLinear');
  const curve = checkCurve(points, 'piecewiseLinear: points');
  const start = curve[0][1];
  const terms = curve.slice(1).flatMap(([right, top], i) => {
    const [left, bottom] = curve[i];
    const slope = (top - bottom) / (right - left);
    return slope === 0 ? [] : [at.max(left).min(right).sub(left).mul(slope)];
  });
  return terms.reduce((sum, term) => sum.add(term), scalarOf(start, 'piecewiseLinear'));
}
