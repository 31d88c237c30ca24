import { collectThrown } from '../faults/thrown';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import { type Ahead, lookAhead, lookNowhere } from './ahead';
import type { Phase } from './phases';
import type { Group, Plan } from './plan';

/** Bodies of a tile: a dozen f32 columns of it are 100 KB, and the next tile's fit beside them in the second-level cache. */
const TILE_ROWS = 2048;

/** Runs every phase once. */
export function runPlan(world: PhysicsWorld, { groups, ahead }: Plan, dt: number): void {
  for (let g = 0; g < groups.length; g++) {
    const group = groups[g] as Group;
    if (group.tiled) runTiles(world, group, ahead, dt);
    else runGroup(world, group, world.spans, dt);
  }
}

function runTiles(world: PhysicsWorld, group: Group, ahead: Ahead, dt: number): void {
  const { spans, internal } = world;
  const { tile } = internal;
  for (let r = 0; r < spans.count; r++) {
    const last = spans.bounds[2 * r + 1] as number;
    for (let first = spans.bounds[2 * r] as number; first < last; first += TILE_ROWS) {
      tile.bounds[0] = first;
      tile.bounds[1] = Math.min(first + TILE_ROWS, last);
      if (group.slides) internal.slideScratch(first);
      lookAhead(world, ahead, spans, r);
      runGroup(world, group, tile, dt);
    }
  }
  if (group.slides) internal.slideScratch(0);
  lookNowhere(ahead);
}

function runGroup(world: PhysicsWorld, group: Group, spans: Spans, dt: number): void {
  const clock = world.profile?.clock;
  const { systems } = group;
  for (let s = 0; s < systems.length; s++) {
    const start = clock === undefined ? 0 : clock();
    try {
      const system = systems[s];
      if (typeof system === 'function') system(world, dt);
      else system.run(world, spans, dt);
    } catch (error) {
      collectThrown(world, error);
    }
    if (clock !== undefined) addTime(world, group.phases[s] as Phase, clock() - start);
  }
}

function addTime(world: PhysicsWorld, phase: Phase, time: number): void {
  if (world.profile !== undefined) world.profile.times[phase] += time;
}
