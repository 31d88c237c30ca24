// GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7, 856, 1986) for the linear systems of Newton's method,
// matrix-free: products of the Jacobian with vectors are differences of residuals.

import type { EvaluateForces, PhysicsWorld, Ranges } from '../../world/types.ts';
import { addScaled, type BodyVector, dot, norm, scale } from './body-vectors.ts';
import { BASIS, type Equation, MINUS_ONE, residualAt, Scalar } from './implicit-equation.ts';

/** Relative tolerance of the linear system, near the accuracy of the differences. */
const TOLERANCE = 1e-5;

/**
 * Solves J change = -residual at `best` for `equation.change`; `size` holds the norm of the residual. Writes the
 * norm of the remaining linear residual to `left`.
 */
export function solveLinear(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
): void {
  const { basis, right, triangle, scalars } = equation;
  const size = scalars[Scalar.size];
  scalars[Scalar.factor] = -1 / size;
  scale(world, ranges, basis[0], equation.residual, scalars, Scalar.factor);
  right.fill(0);
  right[0] = size;
  let used = 0;
  while (used < BASIS) {
    const column = used * (BASIS + 1);
    multiply(world, ranges, dt, evaluate, equation, basis[used], basis[used + 1]);
    for (let i = 0; i <= used; i++) {
      dot(world, ranges, basis[used + 1], basis[i], triangle, column + i);
      scalars[Scalar.factor] = -triangle[column + i];
      addScaled(world, ranges, basis[used + 1], basis[used + 1], basis[i], scalars, Scalar.factor);
    }
    norm(world, ranges, basis[used + 1], triangle, column + used + 1);
    const length = triangle[column + used + 1];
    rotate(equation, used);
    used++;
    if (!(length > 0) || Math.abs(right[used]) <= TOLERANCE * size) break;
    scalars[Scalar.factor] = 1 / length;
    scale(world, ranges, basis[used], basis[used], scalars, Scalar.factor);
  }
  combine(world, ranges, equation, used);
  scalars[Scalar.left] = Math.abs(right[used]);
}

/** Computes to = J direction, by a difference of residuals. */
function multiply(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
  direction: BodyVector,
  to: BodyVector,
): void {
  const { best, residual, trial, from, scalars } = equation;
  // The difference is large compared to rounding, and small enough for the forces to be linear.
  norm(world, ranges, best, scalars, Scalar.one);
  norm(world, ranges, residual, scalars, Scalar.other);
  const speeds = Math.max(scalars[Scalar.one], scalars[Scalar.other]);
  norm(world, ranges, from, scalars, Scalar.one);
  const scaleOfStep = Math.max(speeds, (1e-3 * scalars[Scalar.one]) / dt);
  const h = scaleOfStep * (world.precision === 'f32' ? 3e-4 : 1e-8);
  scalars[Scalar.factor] = h;
  addScaled(world, ranges, trial, best, direction, scalars, Scalar.factor);
  residualAt(world, ranges, dt, evaluate, equation, trial, to);
  addScaled(world, ranges, to, to, residual, MINUS_ONE, 0);
  scalars[Scalar.factor] = 1 / h;
  scale(world, ranges, to, to, scalars, Scalar.factor);
}

/** Adds the newest column to the triangle by Givens rotations. */
function rotate({ triangle, cosines, sines, right }: Equation, k: number): void {
  const column = k * (BASIS + 1);
  for (let i = 0; i < k; i++) {
    const a = triangle[column + i];
    const b = triangle[column + i + 1];
    triangle[column + i] = cosines[i] * a + sines[i] * b;
    triangle[column + i + 1] = cosines[i] * b - sines[i] * a;
  }
  const a = triangle[column + k];
  const b = triangle[column + k + 1];
  const length = Math.sqrt(a * a + b * b);
  cosines[k] = length > 0 ? a / length : 1;
  sines[k] = length > 0 ? b / length : 0;
  triangle[column + k] = length;
  right[k + 1] = -sines[k] * right[k];
  right[k] *= cosines[k];
}

/** Computes change = the sum of basis vectors with the weights that solve the triangular system. */
function combine(world: PhysicsWorld, ranges: Ranges, equation: Equation, used: number): void {
  const { triangle, right, solution, basis, change } = equation;
  for (let k = used - 1; k >= 0; k--) {
    let sum = right[k];
    for (let j = k + 1; j < used; j++) sum -= triangle[j * (BASIS + 1) + k] * solution[j];
    const pivot = triangle[k * (BASIS + 1) + k];
    solution[k] = pivot > 0 ? sum / pivot : 0;
  }
  scale(world, ranges, change, basis[0], solution, 0);
  for (let k = 1; k < used; k++) addScaled(world, ranges, change, change, basis[k], solution, k);
}
