// Vectors over all bodies and axes, as columns, for iterative solvers. Numbers are passed in array cells, because a
// number passed to a function, or returned, becomes garbage.
import { AXES } from '../../memory/axes.ts';
import type { AxisAddresses } from '../../memory/columns.ts';
import type { PhysicsWorld, Ranges } from '../../world/types.ts';
import { integratorKernels } from './integrator-kernels.ts';

export type BodyVector = Readonly<AxisAddresses>;

/** to = from. */
export function copyVector(world: PhysicsWorld, ranges: Ranges, to: BodyVector, from: BodyVector): void {
  const axes = AXES[world.dimensions];
  for (let n = 0; n < axes.length; n++) {
    const axis = axes[n];
    for (let r = 0; r < ranges.count; r++) {
      world.kernels.copyColumn(to[axis], from[axis], ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
}

/** to = a + factor b, with the factor in `cells[at]`. */
export function addScaled(
  world: PhysicsWorld,
  ranges: Ranges,
  to: BodyVector,
  a: BodyVector,
  b: BodyVector,
  cells: Float64Array,
  at: number,
): void {
  const { addScaledColumn } = integratorKernels(world);
  const factor = cells[at];
  const axes = AXES[world.dimensions];
  for (let n = 0; n < axes.length; n++) {
    const axis = axes[n];
    for (let r = 0; r < ranges.count; r++) {
      addScaledColumn(to[axis], a[axis], b[axis], factor, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
}

/** to = factor a, with the factor in `cells[at]`. */
export function scale(
  world: PhysicsWorld,
  ranges: Ranges,
  to: BodyVector,
  a: BodyVector,
  cells: Float64Array,
  at: number,
): void {
  const { scaleColumn } = integratorKernels(world);
  const factor = cells[at];
  const axes = AXES[world.dimensions];
  for (let n = 0; n < axes.length; n++) {
    const axis = axes[n];
    for (let r = 0; r < ranges.count; r++) {
      scaleColumn(to[axis], a[axis], factor, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
}

/** cells[at] = sum of a b over bodies and axes. */
export function dot(
  world: PhysicsWorld,
  ranges: Ranges,
  a: BodyVector,
  b: BodyVector,
  cells: Float64Array,
  at: number,
): void {
  let sum = 0;
  const axes = AXES[world.dimensions];
  for (let n = 0; n < axes.length; n++) {
    const axis = axes[n];
    for (let r = 0; r < ranges.count; r++) {
      sum += world.kernels.dotColumns(a[axis], b[axis], ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
  cells[at] = sum;
}

/** cells[at] = length of a. */
export function norm(world: PhysicsWorld, ranges: Ranges, a: BodyVector, cells: Float64Array, at: number): void {
  dot(world, ranges, a, a, cells, at);
  cells[at] = Math.sqrt(cells[at]);
}
