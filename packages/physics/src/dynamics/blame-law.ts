// Finds the law that produced a non-finite force; called only after a step failed for that reason.

import { AXES } from '../memory/axes.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type LawLoop, makeLawLoop } from './evaluate-forces.ts';
import { type LawForce, lawsOf } from './sum-of-laws.ts';

/** A separate loop for each law of a world. */
const singleLaws = cachedWithPlan((world) =>
  lawsOf(world.forces).map((law): [LawForce, LawLoop] => [law, makeLawLoop(world, [law], false)]),
);

/** Returns by row the laws whose force or torque on a body of rows [first, last) is not finite in the present state. */
export function faultyLaws(world: PhysicsWorld, first: number, last: number, dt: number): Map<number, string> {
  const blamed = new Map<number, string>();
  const { kernels, scratch, addresses } = world;
  for (const axis of AXES[3]) kernels.copyColumn(scratch.at.startVelocity[axis], addresses.Velocity[axis], first, last);
  for (const [{ name }, { block, run }] of singleLaws(world)) {
    block.write(dt, world.time, 0);
    run(first, last, 0);
    for (let row = first; row < last; row++) {
      if (!hasFiniteForce(world, row) && !blamed.has(row)) blamed.set(row, name);
    }
  }
  return blamed;
}

function hasFiniteForce({ scratch: { force, torque }, dimensions }: PhysicsWorld, row: number): boolean {
  return AXES[dimensions].every((axis) => Number.isFinite(force[axis][row])) && Number.isFinite(torque.z[row]);
}
