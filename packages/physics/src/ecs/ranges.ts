import { bitOf } from '../components/membership.ts';
import type { PhysicsWorld, Ranges } from '../world/types.ts';
import { assertUsable } from './guards.ts';

/** Ranges separated by fewer blocks are joined: processing empty rows costs less than another call. */
const JOIN_BLOCKS = 8;

/** Updates `world.ranges` and `world.ids` if the component bits changed. */
export function refreshRanges(world: PhysicsWorld): void {
  if (world.internal.rangesVersion === world.versions.membership) return;
  const { kernels, internal } = world;
  const bodies = bitOf('Position');
  const rows = Math.ceil((world.lastId + 1) / 16) * 16;
  world.ranges.count = kernels.buildRanges(internal.membersAt, bodies, rows, JOIN_BLOCKS, internal.rangesAt);
  internal.bodyList.count = kernels.collectEntities(internal.membersAt, bodies, world.lastId + 1, internal.idsAt);
  internal.rangesVersion = world.versions.membership;
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
  refreshRanges(world);
  return world.internal.bodyList;
}
