// Runs a step as one loop. Where the loop stops, because a value is out of range, the bodies there are looked at one by
// one; all others go on as if nothing had happened.
import type { CompiledLoop, Loop } from '../laws/compile.ts';
import { wordColumn } from '../memory/columns.ts';
import { resource } from '../memory/resource.ts';
import { keptWithPlan } from '../world/execution-plan.ts';
import type { Fusion, LocalSystem, PhysicsWorld, Ranges, Scheme } from '../world/types.ts';
import { schemeLoops } from './advance-scheme.ts';
import { blamedLaws } from './blame-law.ts';
import { anyForceTurns, lawLoopOf } from './evaluate-forces.ts';
import { layoutOf } from './layout.ts';
import { ParameterBlock, variantOf } from './parameter-block.ts';
import { lastStepOf, schemeMemory } from './scheme-memory.ts';
import type { Box, StepFeatures } from './step-features.ts';
import { ownersOf, stepLoopSource } from './step-loop.ts';
import { lawsOf } from './sum-of-laws.ts';
import { repairRows } from './validate-state.ts';
import { makeWorldLoop } from './world-loop.ts';

/** Walls that the loop can test: a system of the `walls` phase with a box. */
export interface BoxSystem extends LocalSystem {
  readonly box: Box;
  /** Takes the memory that it needs. */
  prepare(world: PhysicsWorld): unknown;
  /** Brings back the bodies of a list: see `WallTest`. Says whether all velocities are in range. */
  bounceListed(world: PhysicsWorld, list: number, dt: number): boolean;
}

interface StepLoop {
  readonly compiled: CompiledLoop;
  readonly run: Loop;
  readonly block: ParameterBlock;
}

/** Vectors of bodies at walls: the end of the list, then byte offsets in a column of reals. */
const wallList = resource(({ internal, rows }) => wordColumn(internal.arena, rows / 2 + 16, 'bodies at walls'));

/** The loop of a world's steps; made when the plan changes. */
export const stepLoop = keptWithPlan((world): StepLoop => {
  const scheme = world.integrator.scheme as Scheme;
  const fusion = world.internal.plan?.fusion as Fusion;
  (fusion.walls as BoxSystem | undefined)?.prepare(world);
  const laws = lawsOf(world.forces);
  const owners = ownersOf(scheme, laws);
  const block = new ParameterBlock(world, [...owners.values()], scheme.stages);
  const features: StepFeatures = {
    savesPose: fusion.begin,
    savesVelocity: !fusion.check,
    hasTorque: anyForceTurns(world),
    box: (fusion.walls as BoxSystem | undefined)?.box,
    list: fusion.walls === undefined ? 0 : wallList(world)[1],
    memory: schemeMemory(world, scheme).columns,
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
  return { block, ...makeWorldLoop(world, key, () => stepLoopSource(block, scheme, laws, owners, features)) };
});

/** Makes, before a step, the loops that it will run: what goes wrong then comes out of `step`, and nothing has moved. */
export function prepareLoops(world: PhysicsWorld): void {
  const { integrator, internal } = world;
  if (internal.plan?.fusion !== undefined) stepLoop(world);
  else {
    lawLoopOf(world);
    if (integrator.scheme !== undefined && integrator.advance === undefined) schemeLoops(world);
  }
}

/** Bodies after which those at walls are brought back while their columns are still in the cache. */
const CHUNK_ROWS = 4096;

/** Moves all bodies by one step. */
export function runStepLoop(world: PhysicsWorld, ranges: Ranges, dt: number): void {
  const { run, block } = stepLoop(world);
  const { plan, counts } = world.internal;
  const walls = plan?.fusion?.walls as BoxSystem | undefined;
  if (walls !== undefined) clearWallList(world);
  block.write(dt, world.time, lastStepOf(world, world.integrator.scheme as Scheme, dt));
  // Friction at a wall turns bodies, which comes after the torques of the step: where nothing turns, nothing has to wait.
  const bounces = walls !== undefined && counts.AngularVelocity === 0;
  for (let r = 0; r < ranges.count; r++) {
    const end = ranges.bounds[2 * r + 1];
    const rows = bounces ? CHUNK_ROWS : end;
    for (let first = ranges.bounds[2 * r]; first < end; first += rows) {
      const last = Math.min(first + rows, end);
      runRows(world, run, first, last, dt);
      if (bounces && !bounceList(world, walls, dt)) repairRows(world, first, last, 'finish');
    }
  }
}

function runRows(world: PhysicsWorld, run: Loop, first: number, last: number, dt: number): void {
  let row = run(first, last, 1);
  while (row < last) {
    row = stepOverBad(world, run, row, dt);
    if (row < last) row = run(row, last, 1);
  }
}

/** Bodies of one vector, among which some are out of range. */
function stepOverBad(world: PhysicsWorld, run: Loop, first: number, dt: number): number {
  const last = first + (world.precision === 'f32' ? 4 : 2);
  repairRows(world, first, last, 'begin');
  const blamed = blamedLaws(world, first, last, dt);
  run(first, last, 0);
  repairRows(world, first, last, 'finish', blamed);
  return last;
}

/** Brings back the bodies that the loop found at walls and that were left there. */
export function bounceFromBox(world: PhysicsWorld, walls: BoxSystem, ranges: Ranges, dt: number): void {
  if (bounceList(world, walls, dt)) return;
  for (let r = 0; r < ranges.count; r++) repairRows(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1], 'finish');
}

/** Brings back the bodies of the list, and says whether their velocities are in range. */
function bounceList(world: PhysicsWorld, walls: BoxSystem, dt: number): boolean {
  const [words, at] = wallList(world);
  if (words[0] === at + 4) return true;
  const isGood = walls.bounceListed(world, at, dt);
  clearWallList(world);
  return isGood;
}

function clearWallList(world: PhysicsWorld): void {
  const [words, at] = wallList(world);
  words[0] = at + 4;
}
