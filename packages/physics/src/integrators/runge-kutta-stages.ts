// What explicit Runge-Kutta methods are made of in which every stage starts from the derivative of the one before alone:
// the state at the start of the step, and the weighted sum of the derivatives (v, F/m) so far in `stage1` and `stage2`.
import { AXES, clearAxes } from '../store/axes';
import { eachRun, type Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';

/** Empties the sums of a step. */
export const clearSums = eachRun((world, first, last) => {
  const { stage1, stage2 } = world.scratch.at;
  const axes = AXES[world.dimensions];
  clearAxes(world, stage1, axes, first, last);
  clearAxes(world, stage2, axes, first, last);
});

/** With k = (v, F/m) here: adds `weight` k to the sums and moves the state to start + `next` k. */
export function rungeKuttaStage(world: PhysicsWorld, spans: Spans, weight: number, next: number): void {
  const { kernels, addresses, scratch } = world;
  const { Position, Velocity, Mass } = addresses;
  const { startVelocity, stage1, stage2, force } = scratch.at;
  for (const axis of AXES[world.dimensions]) {
    const x = Position[axis];
    const v = Velocity[axis];
    const x0 = world.previousAddresses.Position[axis];
    const v0 = startVelocity[axis];
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r] as number;
      const last = spans.bounds[2 * r + 1] as number;
      const f = force[axis];
      kernels.rungeKuttaStageAxis(x, v, x0, v0, stage1[axis], stage2[axis], f, Mass.value, weight, next, first, last);
    }
  }
}

/** Moves the state to start + dt sum. */
export const finishSums = eachRun((world, first, last, dt) => {
  const { kernels, addresses, previousAddresses, scratch } = world;
  const { startVelocity, stage1, stage2 } = scratch.at;
  for (const axis of AXES[world.dimensions]) {
    const x = addresses.Position[axis];
    const v = addresses.Velocity[axis];
    const x0 = previousAddresses.Position[axis];
    kernels.rungeKuttaFinishAxis(x, v, x0, startVelocity[axis], stage1[axis], stage2[axis], dt, first, last);
  }
});
