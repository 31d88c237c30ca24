// Runs a fixed-stage scheme if some force is not a law. The scheme is split at each force evaluation: each segment is a
// loop that moves the bodies to the state of the next evaluation, and stores intermediate values for later segments in
// scratch columns. The first segment saves the state at the start of the step, from which the later ones continue.
import type { Loop } from '../laws/compile.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { PhysicsWorld, Ranges, Scheme } from '../world/types.ts';
import { cutScheme, intermediateColumns } from './cut-scheme.ts';
import { sumForces } from './evaluate-forces.ts';
import { layoutOf } from './layout.ts';
import { ParameterBlock, variantOf } from './parameter-block.ts';
import { runChecked } from './run-checked.ts';
import { lastStepOf, schemeMemory } from './scheme-memory.ts';
import { quarantineBadForces, repairRows } from './validate-state.ts';
import { WorldColumns } from './world-columns.ts';
import { makeWorldLoop, type WorldLoop } from './world-loop.ts';

interface SchemeLoops {
  readonly block: ParameterBlock;
  /** The segments: one more than the evaluations. */
  readonly segments: readonly WorldLoop[];
}

/** The loops of a world whose integrator has fixed stages and whose forces are not all laws. */
export const schemeLoops = cachedWithPlan((world): SchemeLoops => {
  const scheme = world.integrator.scheme as Scheme;
  const block = new ParameterBlock(world, [scheme], scheme.stages);
  const memory = schemeMemory(world, scheme).kept;
  const sources = cutScheme(new WorldColumns(world, block, () => scheme), scheme, memory);
  const key = JSON.stringify(['pieces', layoutOf(world, block), intermediateColumns(world), memory, scheme.structure]);
  const variant = JSON.stringify(variantOf(scheme));
  const segments = sources.map((source, i) => makeWorldLoop(world, `${key} ${i} ${variant}`, () => source));
  return { block, segments };
});

/** Advances all bodies by one step. */
export function advanceScheme(world: PhysicsWorld, ranges: Ranges, dt: number): void {
  const { block, segments } = schemeLoops(world);
  const { stages } = world.integrator.scheme as Scheme;
  block.write(dt, world.time, lastStepOf(world, world.integrator.scheme as Scheme, dt));
  for (let p = 0; p < segments.length; p++) {
    const handleInvalid = p === 0 ? start : p < stages.length ? proceed : end;
    for (let r = 0; r < ranges.count; r++) {
      runChecked(world, segments[p], ranges.bounds[2 * r], ranges.bounds[2 * r + 1], dt, handleInvalid);
    }
    if (p < stages.length) sumForces(world, ranges, world.time + stages[p] * dt);
  }
}

/** Repairs what was written between steps before the state is saved. */
function start(world: PhysicsWorld, run: Loop, first: number, last: number): void {
  repairRows(world, first, last, 'begin');
  run(first, last, 0);
}

/** Keeps a bad force from the state of the next evaluation, where springs would pass it on. */
function proceed(world: PhysicsWorld, run: Loop, first: number, last: number): void {
  quarantineBadForces(world, first, last);
  run(first, last, 0);
}

function end(world: PhysicsWorld, run: Loop, first: number, last: number): void {
  proceed(world, run, first, last);
  repairRows(world, first, last, 'finish');
}
