import { bitOf } from '../components/membership.ts';
import type { PhysicsWorld, Ranges } from '../world/types.ts';
import { assertUsable } from './guards.ts';

/** Ranges separated by fewer blocks are joined: processing empty rows costs less than another call. */
const JOIN_BLOCKS = 8;

/** Updates what a step, or who reads forces between two, goes over: `world.ranges`, and the number of rows in use. */
export function findRows(world: PhysicsWorld): void {
  refreshRanges(world);
  world.internal.sweptRows = rowsInUse(world);
}

function rowsInUse({ lastId }: PhysicsWorld): number {
  return Math.ceil((lastId + 1) / 16) * 16;
}

/** Updates `world.ranges` and `world.ids` if the component bits changed, or rows were left out. */
function refreshRanges(world: PhysicsWorld): void {
  const { kernels, internal } = world;
  const isCurrent = internal.rangesVersion === world.versions.membership;
  if (isCurrent && !internal.leavesOutWaiting) return;
  buildRanges(world, false);
  if (isCurrent) return;
  const { membersAt, idsAt } = internal;
  internal.bodyList.count = kernels.collectEntities(membersAt, bitOf('Position'), world.lastId + 1, idsAt);
  internal.rangesVersion = world.versions.membership;
}

/**
 * Takes rows out of `world.ranges` for the rest of the step in which entities wait in the pool of an emitter and nothing
 * else is: laws would be computed for all of them.
 */
export function leaveOutWaiting(world: PhysicsWorld): void {
  buildRanges(world, true);
}

function buildRanges(world: PhysicsWorld, leavesOutWaiting: boolean): void {
  const { kernels, internal, ranges } = world;
  const { membersAt, rangesAt } = internal;
  const bodies = bitOf('Position');
  ranges.count = kernels.buildRanges(
    membersAt,
    bodies,
    rowsInUse(world),
    JOIN_BLOCKS,
    rangesAt,
    leavesOutWaiting ? 1 : 0,
  );
  internal.leavesOutWaiting = leavesOutWaiting;
}

/** Returns a function that applies `run` to every range of rows; for systems and integrators. */
export function forEachRange(
  run: (world: PhysicsWorld, first: number, last: number, dt: number) => void,
): (world: PhysicsWorld, ranges: Ranges, dt: number) => void {
  return (world, ranges, dt) => {
    for (let r = 0; r < ranges.count; r++) run(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1], dt);
  };
}

/** The ids of all bodies in ascending order: `ids[0 … count)`. */
export interface BodyList {
  readonly ids: Uint32Array;
  readonly count: number;
}

/**
 * Returns the present bodies. The object is the same at every call, so copy what you need across edits. @throws
 * PhysicsError E_DESTROYED
 */
export function bodies(world: PhysicsWorld): BodyList {
  assertUsable(world);
  // In a step the list is current, and `world.ranges` must stay as they are: a force or a system may walk them as it asks.
  if (world.state !== 'stepping') refreshRanges(world);
  return world.internal.bodyList;
}
