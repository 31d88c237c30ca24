import { collectThrown } from '../faults/thrown';
import { dropBadForces } from '../schedule/quarantine';
import { AXES, clearAxes } from '../store/axes';
import { holdUnmoved } from '../store/incomplete';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import { type Assign, assignerOf } from './assign';
import type { Force } from './force';

/**
 * The moment `offset` seconds into the step, for forces that ask for it; zero where none does. A real number that is
 * handed on through calls, tile by tile, becomes garbage, and a zero does not.
 */
export function momentOf(world: PhysicsWorld, offset: number): number {
  return world.internal.plan?.forcesTimeless === true ? 0 : world.time + offset;
}

/** Evaluates all forces of the world on the bodies of `spans` at `time`, into `world.scratch.force`. */
export type EvaluateForces = (world: PhysicsWorld, spans: Spans, time: number) => void;

export const evaluateForces: EvaluateForces = (world, spans, time) => {
  const { forces } = world;
  const assign = forces.length === 0 ? undefined : assignerOf(forces[0]);
  for (let r = 0; r < spans.count; r++) begin(world, assign, spans.bounds[2 * r], spans.bounds[2 * r + 1]);
  for (let f = assign === undefined ? 0 : 1; f < forces.length; f++) {
    try {
      accumulate(world, forces[f] as Force, spans, time);
    } catch (error) {
      collectThrown(world, error);
    }
  }
  for (let r = 0; r < spans.count; r++) finish(world, spans.bounds[2 * r], spans.bounds[2 * r + 1]);
};

/** Puts the columns at zero, or at the first force where that can be written over them. */
function begin(world: PhysicsWorld, assign: Assign | undefined, first: number, last: number): void {
  const { force, torque } = world.scratch.at;
  if (anyForceTurns(world)) clearAxes(world, torque, AXES[3], first, last);
  if (assign === undefined) clearAxes(world, force, AXES[world.dimensions], first, last);
  else assign(world, first, last);
}

function finish(world: PhysicsWorld, first: number, last: number): void {
  holdUnmoved(world, first, last);
  // Forces that look at one body leave a bad one alone with it, unless the scheme mixes bodies, as Jacobi coordinates do.
  const isAlone = world.internal.plan?.forcesLocal === true && world.integrator.wholeWorld !== true;
  if (!isAlone) dropBadForces(world, first, last);
}

function accumulate(world: PhysicsWorld, force: Force, spans: Spans, time: number): void {
  if (!force.local) {
    force.accumulate(world, 0, world.internal.sweptRows, time);
    return;
  }
  for (let r = 0; r < spans.count; r++) {
    force.accumulate(world, spans.bounds[2 * r] as number, spans.bounds[2 * r + 1] as number, time);
  }
}

/** Whether some force of the world adds torque. */
export function anyForceTurns({ forces }: PhysicsWorld): boolean {
  for (let f = 0; f < forces.length; f++) if (forces[f].turns === true) return true;
  return false;
}

/** Lets every force look at the world before the step. */
export function prepareForces(world: PhysicsWorld, dt: number): void {
  const { forces } = world;
  for (let f = 0; f < forces.length; f++) forces[f].prepare?.(world, dt);
}

/** Whether every force reads only its own body, so that a step may run tile by tile. */
export function allForcesLocal(world: PhysicsWorld): boolean {
  return world.forces.every((force) => force.local);
}
