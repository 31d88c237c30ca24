// Removes springs whose tension exceeds their `breakForce` at the end of a step.
//
// The tension is that at the end of the step: under `xpbd` the mean of the constraint's over the last sub-step, its
// impulse over h; k (d - L) by Hooke's law under the force `springs()`. The energy of a broken spring is lost. Under
// `xpbd` the impulse follows from how far positions are corrected, about a h²/2 at the acceleration a = T/m of what the
// spring holds. Of less than the rounding of a position nothing is seen: in f32, 2e-7 m at a distance of 2 m from the
// origin, springs hold more than they should in sub-steps below 1/1200 s at 10 m/s². Cost: one comparison per spring and
// step, and none if no spring can break.
import { despawn } from '../bodies/spawn.ts';
import { scanSprings } from '../forces/support/spring-table.ts';
import { ConstraintTableWord as Word } from '../memory/layouts.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { nameSystem } from '../world/name-system.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { allocateRows, type ConstraintTable, constraintTable } from './constraint-table.ts';
import { constraintKernels } from './kernels.ts';

/** The springs that broke. */
export interface BrokenSprings {
  /** Springs that broke in the last step, ascending; their entities are gone. */
  readonly ids: readonly number[];
  /** The number of springs that broke since the world was made. */
  readonly total: number;
}

const state = namedResource('broken constraints', () => ({ ids: [] as number[], total: 0 }));

/** Returns the springs that broke: the same object on each call. @throws PhysicsError E_DESTROYED */
export function brokenSprings(world: PhysicsWorld): BrokenSprings {
  return state(world);
}

/** System of the `finish` phase: `world.phases.finish.push(breakSprings)`. */
export const breakSprings = /* @__PURE__ */ nameSystem('break springs', (world: PhysicsWorld) => {
  const broken = state(world);
  world.internal.breaksSprings = true;
  if (broken.ids.length > 0) broken.ids.length = 0;
  if (world.internal.counts.Spring === 0) return;
  const table = constraintTable(world);
  const count = findBroken(world, table);
  if (count === 0) return;
  const ids = new Uint32Array(world.memory.buffer, table.words[Word.broken], count).slice().sort();
  for (const id of ids) {
    despawn(world, id);
    broken.ids.push(id);
  }
  broken.total += count;
});

function findBroken(world: PhysicsWorld, table: ConstraintTable): number {
  const kernels = constraintKernels(world);
  if (world.integrator.solvesSprings === true) {
    return table.words[Word.breakable] > 0 ? kernels.findBroken(table.at, table.substep[0]) : 0;
  }
  allocateRows(world, table);
  scanSprings(world);
  return kernels.findOverloaded(table.at);
}
