import { bitOf } from '../components/all.ts';
import type { PhysicsWorld, Ranges } from '../world/types.ts';
import { assertUsable } from './guards.ts';

/** Runs of bodies closer than this many blocks are swept as one: inert rows cost less than another call. */
const JOIN_BLOCKS = 8;

/** Brings `world.ranges` and `world.ids` up to date with the membership bits, when those changed. */
export function refreshRanges(world: PhysicsWorld): void {
  if (world.internal.rangesVersion === world.versions.membership) return;
  const { kernels, internal } = world;
  const bodies = bitOf('Position');
  const rows = Math.ceil((world.lastId + 1) / 16) * 16;
  world.ranges.count = kernels.buildRuns(internal.membersAt, bodies, rows, JOIN_BLOCKS, internal.rangesAt);
  internal.bodyList.count = kernels.listIds(internal.membersAt, bodies, world.lastId + 1, internal.idsAt);
  internal.rangesVersion = world.versions.membership;
}

/** A function that does to every run of rows what `run` does to one; for systems and for the parts of integrators. */
export function forEachRange(
  run: (world: PhysicsWorld, first: number, last: number, dt: number) => void,
): (world: PhysicsWorld, ranges: Ranges, dt: number) => void {
  return (world, ranges, dt) => {
    for (let r = 0; r < ranges.count; r++) run(world, ranges.bounds[2 * r], ranges.bounds[2 * r + 1], dt);
  };
}

/** The ids of all bodies, ascending: `ids[0 … count)`. */
export interface BodyList {
  readonly ids: Uint32Array;
  readonly count: number;
}

/** The bodies as they are now. The same object every time, so keep a copy of what you need across edits. @throws PhysicsError E_DESTROYED */
export function bodies(world: PhysicsWorld): BodyList {
  assertUsable(world);
  refreshRanges(world);
  return world.internal.bodyList;
}
