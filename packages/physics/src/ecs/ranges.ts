import { bitOf } from '../components/all.ts';
import type { PhysicsWorld, Spans } from '../world/types.ts';
import { assertUsable } from './guards.ts';

/** Runs of bodies closer than this many blocks are swept as one: inert rows cost less than another call. */
const JOIN_BLOCKS = 8;

/** Brings `world.spans` and `world.ids` up to date with the membership bits, when those changed. */
export function refreshSpans(world: PhysicsWorld): void {
  if (world.internal.spansVersion === world.versions.membership) return;
  const { kernels, internal } = world;
  const bodies = bitOf('Position');
  const rows = Math.ceil((world.lastId + 1) / 16) * 16;
  world.spans.count = kernels.buildRuns(internal.membersAt, bodies, rows, JOIN_BLOCKS, internal.spansAt);
  internal.bodyList.count = kernels.listIds(internal.membersAt, bodies, world.lastId + 1, internal.idsAt);
  internal.spansVersion = world.versions.membership;
}

/** A function that does to every run of rows what `run` does to one; for systems and for the parts of integrators. */
export function eachRun(
  run: (world: PhysicsWorld, first: number, last: number, dt: number) => void,
): (world: PhysicsWorld, spans: Spans, dt: number) => void {
  return (world, spans, dt) => {
    for (let r = 0; r < spans.count; r++) run(world, spans.bounds[2 * r], spans.bounds[2 * r + 1], dt);
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
  refreshSpans(world);
  return world.internal.bodyList;
}
