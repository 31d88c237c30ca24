// The rounding errors of accelerations.
//
// Forces that cancel, as those of a hanging mass, at terminal speed or in the middle between equal attractors, leave an
// acceleration of rounding errors, which no step is short enough to resolve. They are measured: as the largest change of
// an acceleration when every coordinate and velocity changes by 2ε to 4ε of itself. A scheme rounds them by ε/2, and
// forces, which depend on them, by a few times that.
import { AXES } from '../../memory/axes.ts';
import type { AxisAddresses } from '../../memory/columns.ts';
import type { EvaluateForces, PhysicsWorld, Ranges } from '../../world/types.ts';

const CHANGE = { f32: 2 ** -22, f64: 2 ** -51 } as const;

/**
 * Returns the rounding error, m/s², of the accelerations in the columns at `accelerations`, those of the bodies as they
 * are, at `time`. Changes the bodies, who must be put back.
 */
export function forceRounding(
  world: PhysicsWorld,
  ranges: Ranges,
  evaluate: EvaluateForces,
  time: number,
  accelerations: AxisAddresses,
): number {
  const { bounds, count } = ranges;
  for (let r = 0; r < count; r++) disturb(world, bounds[2 * r], bounds[2 * r + 1]);
  world.internal.isTrial = true;
  evaluate(world, ranges, time);
  world.internal.isTrial = false;
  const mass = world.components.Mass.value;
  let largest = 0;
  for (const axis of AXES[world.dimensions]) {
    const force = world.scratch.force[axis];
    const Column = world.precision === 'f32' ? Float32Array : Float64Array;
    const before = new Column(world.memory.buffer, accelerations[axis], world.rows);
    for (let r = 0; r < count; r++) {
      for (let row = bounds[2 * r]; row < bounds[2 * r + 1]; row++) {
        if (mass[row] > 0) largest = Math.max(largest, Math.abs(force[row] / mass[row] - before[row]));
      }
    }
  }
  return largest;
}

/** Bodies must not move alike, or the forces between those far from the origin would not change. */
function disturb(
  { components: { Position, Velocity }, dimensions, precision }: PhysicsWorld,
  first: number,
  last: number,
) {
  const axes = AXES[dimensions];
  for (let row = first; row < last; row++) {
    // From 1 to 2 times CHANGE: the fractional part of a multiple of the golden ratio, which differs between neighbours.
    const part = (Math.imul(row, 0x9e3779b1) >>> 0) / 2 ** 32;
    const change = (row % 2 === 0 ? 1 + part : -1 - part) * CHANGE[precision];
    for (let n = 0; n < axes.length; n++) {
      Position[axes[n]][row] *= 1 + change;
      Velocity[axes[n]][row] *= 1 - change;
    }
  }
}
