// Evaluates all forces of a world into the force columns: first the forces that are not laws, kernel by kernel, then
// all laws in one loop. Used by integrators that choose their own stages, and if some force is not a law.

import { assertUsable } from '../ecs/guards.ts';
import { clearForcesOfImmovable } from '../ecs/partial-entities.ts';
import { findRows } from '../ecs/ranges.ts';
import { collectThrown } from '../errors/collect-thrown.ts';
import { checkNumber, mustBe } from '../errors/validate.ts';
import type { LoopSource, Store } from '../laws/loop-source.ts';
import { type Axes, zeroVector } from '../laws/vector-algebra.ts';
import { AXES } from '../memory/axes.ts';
import { clearAxes } from '../memory/clear-axes.ts';
import { namedResource } from '../memory/resource.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { EvaluateForces, Force, PhysicsWorld, Ranges } from '../world/types.ts';
import { layoutOf } from './layout.ts';
import { notesOf } from './notes.ts';
import { ParameterBlock, type ParameterOwner, variantOf } from './parameter-block.ts';
import { type LawForce, lawsOf, ownerOf, sumLaws, totalForce } from './sum-of-laws.ts';
import { quarantineBadForces } from './validate-state.ts';
import { WorldColumns } from './world-columns.ts';
import { makeWorldLoop, type WorldLoop } from './world-loop.ts';

/** Length of the step for which forces were last prepared, s. */
export const preparedFor = namedResource('prepared step', () => ({ dt: 0 }));

/**
 * Sums all forces of a world at a time, s, into `world.scratch.force` and `.torque`, N and N m: for integrators of
 * your own, and to read forces between steps.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_DESTROYED
 */
export const evaluateForces: EvaluateForces = (world, ranges, time) => {
  assertUsable(world);
  if (ranges?.bounds === undefined) throw mustBe('ranges of rows, such as `world.ranges`', ranges, 'ranges');
  checkNumber(time, 'time');
  // Between steps bodies may have come since the last one, or there was none.
  if (world.state === 'idle') findRows(world);
  sumForces(world, ranges, time);
  // Forces that read one body confine a bad value to it, unless the scheme couples bodies, as Jacobi coordinates do.
  const confinesBadForces = world.internal.plan?.forcesLocal === true && world.integrator.wholeWorld !== true;
  if (confinesBadForces || world.internal.isTrial) return;
  for (let r = 0; r < ranges.count; r++) quarantineBadForces(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
};

/** Evaluates all forces without a check of their values. */
export function sumForces(world: PhysicsWorld, ranges: Ranges, time: number): void {
  const lawLoop = lawLoopOf(world);
  if (lawLoop === undefined || lawLoop.addsToColumns) accumulateKernels(world, ranges, time);
  if (lawLoop !== undefined) {
    lawLoop.block.write(preparedFor(world).dt, time, 0);
    for (let r = 0; r < ranges.count; r++) lawLoop.run(ranges.bounds[2 * r], ranges.bounds[2 * r + 1], 0);
  }
  for (let r = 0; r < ranges.count; r++) {
    clearForcesOfImmovable(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  }
}

/** Clears the columns and calls every force that is not a law. */
function accumulateKernels(world: PhysicsWorld, ranges: Ranges, time: number): void {
  for (let r = 0; r < ranges.count; r++) clearForces(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
  const forces = forcesOfStep(world);
  for (let f = 0; f < forces.length; f++) {
    const each = forces[f];
    if (each.accumulate === undefined) continue;
    if (!each.local) accumulateRows(world, each, 0, world.internal.sweptRows, time);
    else
      for (let r = 0; r < ranges.count; r++) {
        if (!accumulateRows(world, each, ranges.bounds[2 * r], ranges.bounds[2 * r + 1], time)) break;
      }
  }
}

export function clearForces(world: PhysicsWorld, first: number, last: number): void {
  const { force, torque } = world.scratch.at;
  clearAxes(world, force, AXES[world.dimensions], first, last);
  if (anyForceAppliesTorque(world)) clearAxes(world, torque, AXES[3], first, last);
}

/** Calls a force that is not a law, and returns whether it returned; what it throws is collected. */
export function accumulateRows(world: PhysicsWorld, force: Force, first: number, last: number, time: number): boolean {
  try {
    force.accumulate?.(world, first, last, time);
    return true;
  } catch (error) {
    collectThrown(world, error);
    return false;
  }
}

/** The forces of a step are those with which it began: what is added or taken out meanwhile waits for the next. */
const forcesOfStep = cachedWithPlan(({ forces }) => forces.slice());

/** Returns whether any force of the world, or of the step that is running, adds torque. */
export const anyForceAppliesTorque = cachedWithPlan((world) =>
  forcesOfStep(world).some(({ appliesTorque }) => appliesTorque === true),
);

/**
 * Prepares every force for the step. Forces that consume fuel come last, so that nothing has been consumed if
 * another force throws and the step is rejected.
 */
export function prepareForces(world: PhysicsWorld, dt: number): void {
  const forces = forcesOfStep(world);
  preparedFor(world).dt = dt;
  for (let f = 0; f < forces.length; f++) if (forces[f].consumes === undefined) forces[f].prepare?.(world, dt);
  for (let f = 0; f < forces.length; f++) if (forces[f].consumes !== undefined) forces[f].prepare?.(world, dt);
}

/** The loop of all laws of a world; undefined if it has none. */
export const lawLoopOf = cachedWithPlan((world): LawLoop | undefined => {
  const laws = lawsOf(world.forces);
  return laws.length === 0 ? undefined : makeLawLoop(world, laws, laws.length < world.forces.length);
});

export interface LawLoop extends WorldLoop {
  readonly block: ParameterBlock;
  readonly addsToColumns: boolean;
}

/** Builds a loop that writes the force of laws to the force columns, or adds it. */
export function makeLawLoop(world: PhysicsWorld, laws: readonly LawForce[], addsToColumns: boolean): LawLoop {
  const owners = new Map(laws.map((force): [object, ParameterOwner] => [force, ownerOf(force)]));
  const block = new ParameterBlock(world, [...owners.values()], [0]);
  const hasTorque = anyForceAppliesTorque(world);
  const sources = [...owners.values()].map(variantOf);
  const layout = [layoutOf(world, block), addsToColumns, hasTorque];
  const key = JSON.stringify(['forces', layout, laws.map(({ law }) => law.structure), sources]);
  const loop = makeWorldLoop(world, key, () => {
    const columns = new WorldColumns(world, block, (owner) => owners.get(owner) as ParameterOwner);
    return forceLoopSource(columns, laws, addsToColumns, hasTorque);
  });
  return { block, addsToColumns, ...loop };
}

function forceLoopSource(
  columns: WorldColumns,
  laws: readonly LawForce[],
  addsToColumns: boolean,
  hasTorque: boolean,
): LoopSource {
  const { graph, world } = columns;
  const { addresses, scratch, dimensions, precision } = world;
  const { x, y, z } = scratch.at.torque;
  const none = zeroVector(graph);
  const column = (address: number) => graph.make('real', [], address);
  const currentTorque: Axes =
    dimensions === 2 ? [graph.zero, graph.zero, column(z)] : [column(x), column(y), column(z)];
  const sum = sumLaws(columns, laws, {
    position: columns.axes(addresses.Position),
    velocity: columns.axes(addresses.Velocity),
    startVelocity: columns.axes(scratch.at.startVelocity),
    force: addsToColumns ? columns.axes(scratch.at.force) : none,
    torque: addsToColumns && hasTorque ? currentTorque : none,
    stage: 0,
    time: columns.timeAt(0),
  });
  const stores: Store[] = columns.axisNames.map((axis, i) => ({
    address: scratch.at.force[axis],
    node: totalForce(columns, sum)[i],
  }));
  if (hasTorque) stores.push(...columns.torqueStores(sum.torque));
  return {
    name: 'forces',
    types: { stored: precision, computed: precision },
    stores,
    noteOf: notesOf(world, columns.block),
  };
}
