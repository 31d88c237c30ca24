// Springs that break: one pulled harder than its `breakForce` is removed when the step ends.
//
// The pull is that at the end of the step: the tension of the constraint under `xpbd`, Hooke's k (d - L) under the force
// `springs()`. Nothing else of a step knows of breaking; the energy a broken spring held is lost. Cost: one comparison a
// spring and step, and nothing where no spring can break.
import { despawn } from '../bodies/spawn.ts';
import { scanSprings } from '../forces/support/spring-table.ts';
import { ConstraintTableWord as Word } from '../memory/layouts.gen.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type ConstraintTable, constraintTable, makeRows } from './constraint-table.ts';
import { constraintKernels } from './kernels.ts';

/** What broke. */
export interface BrokenSprings {
  /** Springs broken in the last step, ascending; their entities are gone. */
  readonly ids: readonly number[];
  /** Springs broken since the world was made. */
  readonly total: number;
}

const state = resource(() => ({ ids: [] as number[], total: 0 }));

/** The springs that broke: always the same object. @throws PhysicsError E_DESTROYED */
export function brokenSprings(world: PhysicsWorld): BrokenSprings {
  return state(world);
}

/** System of the `finish` phase: `world.phases.finish.push(breakSprings)`. */
export function breakSprings(world: PhysicsWorld): void {
  const broken = state(world);
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
}

function findBroken(world: PhysicsWorld, table: ConstraintTable): number {
  const kernels = constraintKernels(world);
  if (world.integrator.solvesSprings === true) {
    return table.words[Word.breakable] > 0 ? kernels.findBroken(table.at, table.substep[0]) : 0;
  }
  makeRows(world, table);
  scanSprings(world);
  return kernels.findOverloaded(table.at);
}
