// Evaluates the forces on some rows between two steps, as for particles that were born there. Mutual forces and springs
// are left out, because they would be computed for the entire world.
import { clearForcesOfImmovable } from '../ecs/partial-entities.ts';
import { AXES } from '../memory/axes.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { accumulateRows, clearForces, type LawLoop, lawLoopOf, preparedFor } from './evaluate-forces.ts';
import { lawsOf } from './sum-of-laws.ts';

interface LocalForces {
  readonly lawLoop: LawLoop | undefined;
  /** The forces of one body that are not laws. */
  readonly functions: readonly Force[];
  readonly readsStartVelocity: boolean;
}

const localForcesOf = cachedWithPlan(
  (world): LocalForces => ({
    lawLoop: lawLoopOf(world),
    functions: world.forces.filter(({ local, accumulate }) => local && accumulate !== undefined),
    readsStartVelocity: lawsOf(world.forces).some(({ law }) => law.structure.includes('startVelocity')),
  }),
);

/** Begins evaluations at the present time. Returns whether the world has forces to evaluate. */
export function beginLocalForces(world: PhysicsWorld): boolean {
  if (world.forces.length === 0) return false;
  const { lawLoop, functions } = localForcesOf(world);
  lawLoop?.block.write(preparedFor(world).dt, world.time, 0);
  return lawLoop !== undefined || functions.length > 0;
}

/** Writes the force on rows [first, last), multiples of 16, to the force columns. */
export function evaluateLocalForces(world: PhysicsWorld, first: number, last: number): void {
  const { lawLoop, functions, readsStartVelocity } = localForcesOf(world);
  if (readsStartVelocity) copyStartVelocity(world, first, last);
  if (lawLoop === undefined || lawLoop.addsToColumns) {
    clearForces(world, first, last);
    for (let f = 0; f < functions.length; f++) accumulateRows(world, functions[f], first, last, world.time);
  }
  lawLoop?.run(first, last, 0);
  clearForcesOfImmovable(world, first, last);
}

function copyStartVelocity({ scratch, dimensions, kernels, addresses }: PhysicsWorld, first: number, last: number) {
  for (const axis of AXES[dimensions]) {
    kernels.copyColumn(scratch.at.startVelocity[axis], addresses.Velocity[axis], first, last);
  }
}
