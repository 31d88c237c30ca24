// Runs a step as one loop. Where a value is out of range the loop stops, and the bodies there are handled one by one;
// all others continue unchanged.
import type { Loop } from '../laws/compile.ts';
import { WALL_LIST_BYTES, WallListWord } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import { wallListBytes } from '../memory/wall-list.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Fusion, PhysicsWorld, Ranges, Scheme } from '../world/types.ts';
import { schemeLoops } from './advance-scheme.ts';
import { faultyLaws } from './blame-law.ts';
import type { BoxSystem } from './box-system.ts';
import { anyForceAppliesTorque, lawLoopOf } from './evaluate-forces.ts';
import { impactLoop } from './impact-loop.ts';
import { layoutOf } from './layout.ts';
import { ParameterBlock, variantOf } from './parameter-block.ts';
import { runChecked } from './run-checked.ts';
import { lastStepOf, schemeMemory } from './scheme-memory.ts';
import type { StepFeatures } from './step-features.ts';
import { ownersOf, stepLoopSource } from './step-loop.ts';
import { lawsOf } from './sum-of-laws.ts';
import { repairRows } from './validate-state.ts';
import { makeWorldLoop, type WorldLoop } from './world-loop.ts';

export type { BoxSystem };

interface StepLoop extends WorldLoop {
  readonly block: ParameterBlock;
  readonly savesVelocity: boolean;
}

/** The list of vectors of bodies beyond a wall. */
const wallList = namedResource('wall list', ({ internal, precision, rows }) =>
  allocateRecord(internal.arena, wallListBytes(rows, precision), 'bodies at walls'),
);

/** The loop of a world's steps; rebuilt when the plan changes. */
export const stepLoop = cachedWithPlan((world): StepLoop => {
  const scheme = world.integrator.scheme as Scheme;
  const { plan, recordsContacts } = world.internal;
  const fusion = plan?.fusion as Fusion;
  (fusion.walls as BoxSystem | undefined)?.prepare(world);
  const laws = lawsOf(world.forces);
  const owners = ownersOf(scheme, laws);
  const block = new ParameterBlock(world, [...owners.values()], scheme.stages);
  const features: StepFeatures = {
    savesPose: fusion.begin,
    savesVelocity: fusion.check === undefined || recordsContacts,
    hasTorque: anyForceAppliesTorque(world),
    box: (fusion.walls as BoxSystem | undefined)?.box,
    list: fusion.walls === undefined ? 0 : wallList(world).at,
    recordsContacts,
    memory: schemeMemory(world, scheme).kept,
  };
  const sources = [...owners.values()].map(variantOf);
  const key = JSON.stringify([
    'step',
    layoutOf(world, block),
    scheme.structure,
    laws.map(({ law }) => law.structure),
    sources,
    features,
  ]);
  const { savesVelocity } = features;
  return {
    block,
    savesVelocity,
    ...makeWorldLoop(world, key, () => stepLoopSource(block, scheme, laws, owners, features)),
  };
});

/** Builds the loops before the step, so that errors propagate from `step` before anything moved. */
export function prepareLoops(world: PhysicsWorld): void {
  const { integrator, internal } = world;
  if (internal.plan?.isOneLoop === true) {
    stepLoop(world);
    if (internal.plan.fusion?.walls !== undefined || internal.recordsContacts) impactLoop(world);
  } else {
    lawLoopOf(world);
    if (integrator.scheme !== undefined && integrator.advance === undefined) schemeLoops(world);
  }
}

/**
 * Rows per chunk: bodies at walls are handled after each chunk, while their columns are still in the second-level cache. A
 * fourth of it takes 3 to 10 % longer, because each chunk begins anew; four times as much 5 to 10 % with 10⁶ bodies.
 */
const CHUNK_ROWS = 16384;

/** Advances all bodies by one step. */
export function runStepLoop(world: PhysicsWorld, ranges: Ranges, dt: number): void {
  const loop = stepLoop(world);
  const { block } = loop;
  const { plan, counts, recordsContacts } = world.internal;
  const walls = plan?.fusion?.walls as BoxSystem | undefined;
  if (walls !== undefined) clearWallList(world);
  block.write(dt, world.time, lastStepOf(world, world.integrator.scheme as Scheme, dt));
  // Wall friction changes rotation and must follow the torques of the step, and contacts with walls are listed axis by
  // axis. Otherwise the order does not matter.
  const bounces = walls !== undefined && counts.AngularVelocity === 0 && !recordsContacts;
  for (let r = 0; r < ranges.count; r++) {
    const end = ranges.bounds[2 * r + 1];
    const rows = bounces ? CHUNK_ROWS : end;
    for (let first = ranges.bounds[2 * r]; first < end; first += rows) {
      const last = Math.min(first + rows, end);
      runChecked(world, loop, first, last, dt, stepInvalidRows);
      if (bounces && !bounceList(world, walls, dt)) repairRows(world, first, last, 'finish');
    }
  }
}

/** Handles the bodies of an iteration with at least one out of range. */
function stepInvalidRows(world: PhysicsWorld, run: Loop, first: number, last: number, dt: number): void {
  repairRows(world, first, last, 'begin');
  const blamed = faultyLaws(world, first, last, dt);
  run(first, last, 0);
  repairRows(world, first, last, 'finish', blamed);
}

/** Bounces the bodies that the loop found at walls and did not handle. */
export function bounceFromBox(world: PhysicsWorld, walls: BoxSystem, ranges: Ranges, dt: number): void {
  if (bounceList(world, walls, dt)) return;
  for (let r = 0; r < ranges.count; r++) repairRows(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1], 'finish');
}

/** Bounces the bodies of the list, and returns whether their velocities are in range. */
function bounceList(world: PhysicsWorld, walls: BoxSystem, dt: number): boolean {
  const { words, at } = wallList(world);
  if (words[WallListWord.end] === at + WALL_LIST_BYTES) return true;
  const { savesVelocity } = stepLoop(world);
  const isGood = walls.bounceListed(world, words, at, dt, savesVelocity);
  clearWallList(world);
  return isGood;
}

function clearWallList(world: PhysicsWorld): void {
  const { words, at } = wallList(world);
  words[WallListWord.end] = at + WALL_LIST_BYTES;
}
