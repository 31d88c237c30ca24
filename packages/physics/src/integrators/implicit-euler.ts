// Implicit (backward) Euler: both updates use the state at the end.
//
//   v' = v + F(x', v', t')/m dt        x' = x + v' dt        residual  R(v') = v' - v - F(x + v' dt, v', t')/m dt
//
// First order. Every step divides the amplitude of an oscillator by √(1 + ω² dt²), so it is stable for springs of any
// stiffness at any step, and dissipates energy fast. For stiff, strongly damped systems of which only the slow motion
// matters. Newton's method solves R = 0; the linear systems are solved by matrix-free GMRES from differences of
// forces (Knoll and Keyes, J. Comp. Phys. 193, 357, 2004). It stops when |R|, or the Newton step, is below
// `tolerance` times the velocities, or below 1e-15 m/s in f32 and 1e-140 m/s in f64: for smaller values, squares such
// as that of the length of a spring leave the range of numbers; and also when |R| is the rounding error of forces that
// cancel, which is measured. If it does not converge, as for networks of springs that a step would invert, the best
// velocities are used and an E_CONVERGENCE that names the body with the largest residual is reported. 5 to about 100
// force evaluations, depending on stiffness. A falling and swinging chain of 100 springs or more converges at
// k dt²/m = 100, at 10⁴ in most steps, at 10⁶ in none: shorten the step, or use xpbd. Hairer, Wanner: Solving Ordinary Differential Equations II, IV.3.

import { reportFault } from '../errors/report-fault.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { AXES } from '../memory/axes.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import { addScaled, copyVector, norm } from './support/body-vectors.ts';
import { forceRounding } from './support/force-rounding.ts';
import { solveLinear } from './support/gmres.ts';
import {
  type Equation,
  equationOf,
  MINUS_ONE,
  moveTo,
  residualAt,
  Scalar,
  VECTORS,
} from './support/implicit-equation.ts';
import { integratorKernels } from './support/integrator-kernels.ts';

/** Error control. */
export interface ImplicitEulerOptions {
  /** Maximum residual relative to the velocities; default 1e-10, in f32 at least 1e-5. */
  readonly tolerance?: number;
}

/** Residual below which velocities count as exact, m/s. */
const MIN_SPEED = { f32: 1e-15, f64: 1e-140 } as const;

/** Maximum number of Newton steps; each gains about four digits, fewer for strongly nonlinear forces. */
const MAX_NEWTON_STEPS = 100;

/** Maximum number of halvings of a Newton step that increases the residual. */
const MAX_HALVINGS = 20;

/**
 * Implicit Euler, solved by Newton's method: v' = v + F(x', v', t')/m dt, x' = x + v' dt. First order, stable for
 * springs of any stiffness, and damps what is faster than the step.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function implicitEuler(options: ImplicitEulerOptions = {}): Integrator {
  checkKeys(options, 'implicitEuler', ['tolerance']);
  const tolerance = checkNumber(options.tolerance ?? 1e-10, 'tolerance', { min: 1e-14, max: 0.1 });
  return {
    name: 'implicit Euler',
    order: 1,
    symplectic: false,
    velocityLag: 0.5,
    evaluations: 5,
    columns: 3 * VECTORS,
    wholeWorld: true,
    isStable: () => true,
    prepare(world) {
      equationOf(world);
    },
    advance(world, ranges, dt, evaluateForces) {
      const equation = equationOf(world);
      const { Position, Velocity } = world.addresses;
      copyVector(world, ranges, equation.from, Position);
      copyVector(world, ranges, equation.start, Velocity);
      copyVector(world, ranges, equation.best, Velocity);
      if (!solveNewton(world, ranges, dt, evaluateForces, equation, tolerance)) {
        checkResidual(world, ranges, dt, evaluateForces, equation);
        // A NaN force must affect only its own body: the others take an explicit step.
        const { best, residual, scalars } = equation;
        norm(world, ranges, residual, scalars, Scalar.one);
        if (!Number.isFinite(scalars[Scalar.one])) addScaled(world, ranges, best, best, residual, MINUS_ONE, 0);
      }
      moveTo(world, ranges, equation, equation.best, dt);
    },
  };
}

/** Minimises the residual of `best` by Newton's method; returns whether it converged. */
function solveNewton(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
  tolerance: number,
): boolean {
  const { start, best, residual, scalars } = equation;
  const minTolerance = Math.max(tolerance, world.precision === 'f32' ? 1e-5 : 0);
  residualAt(world, ranges, dt, evaluate, equation, best, residual);
  norm(world, ranges, residual, scalars, Scalar.size);
  for (let i = 0; i < MAX_NEWTON_STEPS; i++) {
    norm(world, ranges, start, scalars, Scalar.one);
    norm(world, ranges, best, scalars, Scalar.other);
    const speed = Math.max(scalars[Scalar.one], scalars[Scalar.other]);
    const threshold = Math.max(minTolerance * speed, MIN_SPEED[world.precision]);
    if (scalars[Scalar.size] <= threshold) return true;
    if (!(scalars[Scalar.size] < Number.POSITIVE_INFINITY)) return false;
    solveLinear(world, ranges, dt, evaluate, equation);
    norm(world, ranges, equation.change, scalars, Scalar.one);
    // A stiff force amplifies the rounding of positions to a residual that cannot vanish; then the step size decides.
    const isConverged = scalars[Scalar.left] < 0.1 * scalars[Scalar.size] && scalars[Scalar.one] <= threshold;
    const isSmaller = lineSearch(world, ranges, dt, evaluate, equation);
    if (isConverged) return true;
    if (!isSmaller) return false;
  }
  return false;
}

/** Line search: halves the Newton step until the residual decreases; returns whether it did. */
function lineSearch(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
): boolean {
  const { best, trial, change, residual, trialResidual, scalars } = equation;
  scalars[Scalar.part] = 1;
  for (let i = 0; i < MAX_HALVINGS; i++) {
    addScaled(world, ranges, trial, best, change, scalars, Scalar.part);
    residualAt(world, ranges, dt, evaluate, equation, trial, trialResidual);
    norm(world, ranges, trialResidual, scalars, Scalar.trialSize);
    if (scalars[Scalar.trialSize] < (1 - 1e-4 * scalars[Scalar.part]) * scalars[Scalar.size]) {
      copyVector(world, ranges, best, trial);
      copyVector(world, ranges, residual, trialResidual);
      scalars[Scalar.size] = scalars[Scalar.trialSize];
      return true;
    }
    scalars[Scalar.part] /= 2;
  }
  return false;
}

/** Reports the largest residual, unless it is the rounding error of forces that cancel. */
function checkResidual(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
): void {
  let worstRow = 0;
  let largest = -1;
  for (let r = 0; r < ranges.count; r++) {
    for (let row = ranges.bounds[2 * r]; row < ranges.bounds[2 * r + 1]; row++) {
      for (const axis of AXES[world.dimensions]) {
        const residual = Math.abs(equation.residualColumns[axis][row]);
        if (residual > largest || Number.isNaN(residual)) {
          largest = residual;
          worstRow = row;
        }
      }
    }
  }
  if (largest <= dt * roundingAtEnd(world, ranges, dt, evaluate, equation)) return;
  reportFault(world, {
    code: 'E_CONVERGENCE',
    entity: worstRow,
    field: 'Velocity',
    value: largest,
    phase: 'integrate',
    hint: 'Take shorter steps, or use the integrator xpbd() for networks of very stiff springs.',
  });
}

/** Returns the rounding error of the accelerations after a step with the best velocities. */
function roundingAtEnd(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
): number {
  const { best, trialResidual: accelerations } = equation;
  residualAt(world, ranges, dt, evaluate, equation, best, accelerations);
  const { accelerationAxis } = integratorKernels(world);
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < ranges.count; r++) {
      const [first, last] = [ranges.bounds[2 * r], ranges.bounds[2 * r + 1]];
      accelerationAxis(accelerations[axis], world.scratch.at.force[axis], world.addresses.Mass.value, first, last);
    }
  }
  return forceRounding(world, ranges, evaluate, world.time + dt, accelerations);
}
