// The equation of a step of implicit Euler, and the columns of its solver.
import { checkRoom } from '../../memory/arena.ts';
import { AXES } from '../../memory/axes.ts';
import { axisColumns, realBytes } from '../../memory/columns.ts';
import { namedResource } from '../../memory/resource.ts';
import type { EvaluateForces, PhysicsWorld, Ranges } from '../../world/types.ts';
import { addScaled, type BodyVector, copyVector } from './body-vectors.ts';
import { integratorKernels } from './integrator-kernels.ts';

/** Maximum dimension of the Krylov space: the maximum number of force evaluations per linear system. */
export const BASIS = 64;

/** Number of vectors of an equation. */
export const VECTORS = BASIS + 1 + 7;

/** Indices of the scalars of a solution, in `scalars`. */
export const enum Scalar {
  /** Length of the step, s. */
  step,
  /** Norm of the residual of the best velocities, and of the trial velocities. */
  size,
  trialSize,
  /** Remaining residual of the linear system. */
  left,
  /** Fraction of the Newton step that is tried. */
  part,
  /** Factor of the next vector operation. */
  factor,
  /** Norms of two vectors to compare. */
  one,
  other,
  count,
}

export const MINUS_ONE = new Float64Array([-1]);

export type Equation = ReturnType<typeof makeEquation>;

export const equationOf = namedResource('implicit equation', makeEquation);

function makeEquation({ internal: { arena }, precision, rows }: PhysicsWorld) {
  checkRoom(arena, 3 * VECTORS, rows * realBytes(precision), 'implicit Euler');
  const make = (what: string) => axisColumns(arena, precision, rows, `implicit Euler: ${what}`);
  const [residualColumns, residual] = make('residual');
  return {
    /** Position and velocity at the start of the step. */
    from: make('start position')[1],
    start: make('start velocity')[1],
    /** The best velocities so far, and their residual. */
    best: make('velocity')[1],
    residual,
    residualColumns,
    /** The trial velocities, and their residual. */
    trial: make('trial')[1],
    trialResidual: make('residual of the trial')[1],
    /** The Newton step. */
    change: make('change')[1],
    basis: Array.from({ length: BASIS + 1 }, () => make('basis')[1]) as readonly BodyVector[],
    /** Column k of the small triangular system, from k (BASIS + 1) on; rotations; right-hand side; solution. */
    triangle: new Float64Array(BASIS * (BASIS + 1)),
    cosines: new Float64Array(BASIS),
    sines: new Float64Array(BASIS),
    right: new Float64Array(BASIS + 1),
    solution: new Float64Array(BASIS),
    scalars: new Float64Array(Scalar.count),
  };
}

/** Sets the bodies to velocities v and the positions after a step with them: x = start + v dt. */
export function moveTo(world: PhysicsWorld, ranges: Ranges, equation: Equation, v: BodyVector, dt: number): void {
  const { Position, Velocity } = world.addresses;
  copyVector(world, ranges, Velocity, v);
  equation.scalars[Scalar.step] = dt;
  addScaled(world, ranges, Position, equation.from, v, equation.scalars, Scalar.step);
}

/** Computes R(v) = v - start - F/m dt with the forces at the positions after the step. */
export function residualAt(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluate: EvaluateForces,
  equation: Equation,
  v: BodyVector,
  to: BodyVector,
): void {
  moveTo(world, ranges, equation, v, dt);
  evaluate(world, ranges, world.time + dt);
  const { implicitResidualAxis } = integratorKernels(world);
  const { force } = world.scratch.at;
  const mass = world.addresses.Mass.value;
  const axes = AXES[world.dimensions];
  for (let n = 0; n < axes.length; n++) {
    const axis = axes[n];
    for (let r = 0; r < ranges.count; r++) {
      const first = ranges.bounds[2 * r];
      const last = ranges.bounds[2 * r + 1];
      implicitResidualAxis(to[axis], v[axis], equation.start[axis], force[axis], mass, dt, first, last);
    }
  }
}
