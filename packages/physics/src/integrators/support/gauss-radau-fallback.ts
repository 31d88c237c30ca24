// A sub-step of the Gauss-Radau scheme whose iteration did not converge, and that cannot be shortened any more.
//
// Bodies whose polynomial is smooth move by it. It is worthless for the others, as for a body under a drag k with k h
// above 3 or so, where each sweep over the nodes multiplies the error: they take a step of first order that stays stable,
//
//   v1 = v + s a h        x1 = x + h v1        s = 1/(1 - q), between 0 and 1
//
// where q is the relative change of the acceleration, along itself, by such a step with s = 1, extrapolated from a
// small part of it. This is the backward Euler step if the force depends on the velocity along it, as drag does.
import type { RealColumn } from '../../components/define.ts';
import { AXES } from '../../memory/axes.ts';
import type { EvaluateForces, PhysicsWorld, Ranges } from '../../world/types.ts';
import {
  LAST_TERM,
  PASSED,
  type Radau,
  START_ACCELERATION,
  START_POSITION,
  START_VELOCITY,
  STEP,
} from './gauss-radau-table.ts';

/** The part of the step from which the change of the acceleration is extrapolated. */
const PART = { f32: 2 ** -8, f64: 2 ** -20 } as const;

/** A polynomial is smooth if its last term is below this fraction of its first two. */
const SMOOTH = 0.01;

/** The columns of an axis: state, force, start of the sub-step, acceleration there, first and last term. */
interface AxisOfBodies {
  readonly x: RealColumn;
  readonly v: RealColumn;
  readonly force: RealColumn;
  readonly startX: RealColumn;
  readonly startV: RealColumn;
  readonly startA: RealColumn;
  readonly firstTerm: RealColumn;
  readonly lastTerm: RealColumn;
}

/** Ends the sub-step of bodies whose polynomial has not converged; all start from what `radauBegin` saved. */
export function endUnconverged(world: PhysicsWorld, ranges: Ranges, radau: Radau, evaluate: EvaluateForces): void {
  const { kernels, table, scalars } = radau;
  const h = scalars[STEP];
  const part = PART[world.precision];
  const axes = axesOf(world, radau);
  const bodies = (visit: (row: number) => void) => {
    const mass = world.components.Mass.value;
    for (let r = 0; r < ranges.count; r++) {
      for (let row = ranges.bounds[2 * r]; row < ranges.bounds[2 * r + 1]; row++) if (mass[row] > 0) visit(row);
    }
  };
  bodies((row) => {
    for (const { x, v, startX, startV, startA } of axes) {
      v[row] = startV[row] + part * h * startA[row];
      x[row] = startX[row] + part * h * (startV[row] + h * startA[row]);
    }
  });
  world.internal.isTrial = true;
  evaluate(world, ranges, world.time + scalars[PASSED]);
  world.internal.isTrial = false;
  for (let r = 0; r < ranges.count; r++) kernels.radauEnd(table, h, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  bodies((row) => {
    if (isSmooth(axes, row)) return;
    const share = stableShare(axes, row, world.components.Mass.value[row], part);
    for (const { x, v, startX, startV, startA } of axes) {
      const end = startV[row] + share * h * startA[row];
      v[row] = end;
      x[row] = startX[row] + h * end;
    }
  });
}

function axesOf(world: PhysicsWorld, { blocks, stride }: Radau): readonly AxisOfBodies[] {
  const { Position, Velocity } = world.components;
  const Column = world.precision === 'f32' ? Float32Array : Float64Array;
  return AXES[world.dimensions].map((axis, n) => {
    const column = (index: number) => new Column(world.memory.buffer, blocks[n] + index * stride, world.rows);
    return {
      x: Position[axis],
      v: Velocity[axis],
      force: world.scratch.force[axis],
      startX: column(START_POSITION),
      startV: column(START_VELOCITY),
      startA: column(START_ACCELERATION),
      firstTerm: column(0),
      lastTerm: column(LAST_TERM),
    };
  });
}

function isSmooth(axes: readonly AxisOfBodies[], row: number): boolean {
  let first = 0;
  let last = 0;
  for (const { startA, firstTerm, lastTerm } of axes) {
    first += Math.abs(startA[row]) + Math.abs(firstTerm[row]);
    last += Math.abs(lastTerm[row]);
  }
  // False for NaN.
  return last <= SMOOTH * first;
}

/** Returns s of the header. */
function stableShare(axes: readonly AxisOfBodies[], row: number, mass: number, part: number): number {
  let product = 0;
  let square = 0;
  for (const { force, startA } of axes) {
    product += (force[row] / mass - startA[row]) * startA[row];
    square += startA[row] * startA[row];
  }
  const share = 1 / (1 - Math.min(0, product / (part * square)));
  return share > 0 ? share : 0;
}
