// Implicit (backward) Euler: both moves use the state at the end.
//
//   v' = v + F(x', v', t')/m dt        x' = x + v' dt        residual  R(v') = v' - v - F(x + v' dt, v', t')/m dt
//
// First order. Every step divides the amplitude of an oscillator by √(1 + ω² dt²), so it is stable for springs of any
// stiffness at any step, and loses energy fast. For what is stiff and heavily damped, where only the slow motion
// matters. The residual is brought to zero by Newton's method; the linear systems are solved by GMRES from differences
// of forces, without a matrix (Knoll and Keyes, J. Comp. Phys. 193, 357, 2004). It ends when |R|, or the Newton step, is
// below `tolerance` times the velocities; when it does not get there, as with nets of springs that a step would turn
// upside down, the best velocities found are taken and the log gets an E_CONVERGENCE that names the body with the
// largest residual. 5 to some hundred force evaluations, by stiffness. A chain of a hundred springs or more, falling and
// swinging, is solved at k dt²/m = 100, at 10⁴ in most steps, at 10⁶ in none: shorten the step, or use xpbd.
// Hairer, Wanner: Solving Ordinary Differential Equations II, IV.3.

import { reportFault } from '../errors/report-fault.ts';
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { AXES } from '../memory/axes.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import { addScaled, copyVector, norm } from './support/body-vectors.ts';
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

/** When the equation counts as solved. */
export interface ImplicitEulerOptions {
  /** Largest residual, in parts of the velocities; default 1e-10, in f32 at least 1e-5. */
  readonly tolerance?: number;
}

/** Newton steps; each gains some four digits, fewer where forces bend. */
const MOST_STEPS = 100;

/** Halvings of a Newton step that leads uphill. */
const MOST_HALVINGS = 20;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
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
      if (!newton(world, ranges, dt, evaluateForces, equation, tolerance)) {
        report(world, ranges, equation);
        // A force that is not a number must meet its own body alone: the others take an explicit step.
        const { best, residual, scalars } = equation;
        norm(world, ranges, residual, scalars, Scalar.one);
        if (!Number.isFinite(scalars[Scalar.one])) addScaled(world, ranges, best, best, residual, MINUS_ONE, 0);
      }
      moveTo(world, ranges, equation, equation.best, dt);
    },
  };
}

/** Brings the residual of `best` to zero; whether it succeeded. */
function newton(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
  tolerance: number,
): boolean {
  const { start, best, residual, scalars } = equation;
  const least = Math.max(tolerance, world.precision === 'f32' ? 1e-5 : 0);
  residualAt(world, ranges, dt, evaluate, equation, best, residual);
  norm(world, ranges, residual, scalars, Scalar.size);
  for (let i = 0; i < MOST_STEPS; i++) {
    norm(world, ranges, start, scalars, Scalar.one);
    norm(world, ranges, best, scalars, Scalar.other);
    const enough = least * Math.max(scalars[Scalar.one], scalars[Scalar.other]);
    if (scalars[Scalar.size] <= enough) return true;
    if (!(scalars[Scalar.size] < Number.POSITIVE_INFINITY)) return false;
    solveLinear(world, ranges, dt, evaluate, equation);
    norm(world, ranges, equation.change, scalars, Scalar.one);
    // A stiff force turns the rounding of positions into a residual that nothing can bring to zero: then the step says it.
    const settled = scalars[Scalar.left] < 0.1 * scalars[Scalar.size] && scalars[Scalar.one] <= enough;
    const isSmaller = search(world, ranges, dt, evaluate, equation);
    if (settled) return true;
    if (!isSmaller) return false;
  }
  return false;
}

/** Goes along the Newton step, half as far each time, until the residual is smaller; whether it became so. */
function search(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
): boolean {
  const { best, trial, change, residual, trialResidual, scalars } = equation;
  scalars[Scalar.part] = 1;
  for (let i = 0; i < MOST_HALVINGS; i++) {
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

function report(world: PhysicsWorld, ranges: Ranges, { residualColumns }: Equation): void {
  let worst = 0;
  let most = -1;
  for (let r = 0; r < ranges.count; r++) {
    for (let row = ranges.bounds[2 * r]; row < ranges.bounds[2 * r + 1]; row++) {
      for (const axis of AXES[world.dimensions]) {
        const here = Math.abs(residualColumns[axis][row]);
        if (here > most || Number.isNaN(here)) {
          most = here;
          worst = row;
        }
      }
    }
  }
  reportFault(world, {
    code: 'E_CONVERGENCE',
    entity: worst,
    field: 'Velocity',
    value: most,
    phase: 'integrate',
    hint: 'Take shorter steps, or for nets of very stiff springs the integrator xpbd().',
  });
}
