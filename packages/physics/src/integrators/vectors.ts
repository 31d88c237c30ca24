// Vectors with an entry for every body and axis, as columns: what iterative solvers calculate with.
import { AXES } from '../store/axes';
import type { AxisAddresses } from '../store/columns';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import { integratorKernels } from './kernels';

export type BodyVector = Readonly<AxisAddresses>;

/** to = from. */
export function copyVector(world: PhysicsWorld, spans: Spans, to: BodyVector, from: BodyVector): void {
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      world.kernels.copyColumn(to[axis], from[axis], spans.bounds[2 * r], spans.bounds[2 * r + 1]);
    }
  }
}

/** to = a + factor b. */
export function addScaled(
  world: PhysicsWorld,
  spans: Spans,
  to: BodyVector,
  a: BodyVector,
  b: BodyVector,
  factor: number,
): void {
  const { addScaledColumn } = integratorKernels(world);
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      addScaledColumn(to[axis], a[axis], b[axis], factor, spans.bounds[2 * r], spans.bounds[2 * r + 1]);
    }
  }
}

/** to = factor a. */
export function scale(world: PhysicsWorld, spans: Spans, to: BodyVector, a: BodyVector, factor: number): void {
  const { scaleColumn } = integratorKernels(world);
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      scaleColumn(to[axis], a[axis], factor, spans.bounds[2 * r], spans.bounds[2 * r + 1]);
    }
  }
}

/** Sum of a b over bodies and axes. */
export function dot(world: PhysicsWorld, spans: Spans, a: BodyVector, b: BodyVector): number {
  let sum = 0;
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      sum += world.kernels.dotColumns(a[axis], b[axis], spans.bounds[2 * r], spans.bounds[2 * r + 1]);
    }
  }
  return sum;
}

export function norm(world: PhysicsWorld, spans: Spans, a: BodyVector): number {
  return Math.sqrt(dot(world, spans, a, a));
}
