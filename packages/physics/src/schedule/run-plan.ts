import { collectThrown } from '../faults/thrown';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';
import { type Ahead, lookAhead, lookNowhere } from './ahead';
import type { LocalSystem, Phase } from './phases';
import type { Group, Plan } from './plan';

/** Bodies of a tile: a dozen f32 columns of it are 100 KB, and the next tile's fit beside them in the second-level cache. */
const TILE_ROWS = 2048;

/** Runs every phase once. */
export function runPlan(world: PhysicsWorld, { groups, ahead }: Plan, dt: number): void {
  for (let g = 0; g < groups.length; g++) {
    const group = groups[g] as Group;
    if (group.tiled) runTiles(world, group, ahead, dt);
    else runWhole(world, group, dt);
  }
}

function runWhole(world: PhysicsWorld, group: Group, dt: number): void {
  const clock = world.profile?.clock;
  const start = clock === undefined ? 0 : clock();
  const system = group.systems[0];
  if (typeof system === 'function') runGuarded(world, system, dt);
  else system?.run(world, world.spans, dt);
  if (clock !== undefined) addTime(world, group.phases[0] as Phase, clock() - start);
}

function runGuarded(world: PhysicsWorld, system: (world: PhysicsWorld, dt: number) => void, dt: number): void {
  try {
    system(world, dt);
  } catch (error) {
    collectThrown(world, error);
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
      runTile(world, group, tile, dt);
    }
  }
  if (group.slides) internal.slideScratch(0);
  lookNowhere(ahead);
}

function runTile(world: PhysicsWorld, group: Group, tile: Spans, dt: number): void {
  const clock = world.profile?.clock;
  const { systems } = group;
  for (let s = 0; s < systems.length; s++) {
    const start = clock === undefined ? 0 : clock();
    try {
      (systems[s] as LocalSystem).run(world, tile, dt);
    } catch (error) {
      collectThrown(world, error);
    }
    if (clock !== undefined) addTime(world, group.phases[s] as Phase, clock() - start);
  }
}

function addTime(world: PhysicsWorld, phase: Phase, time: number): void {
  if (world.profile !== undefined) world.profile.times[phase] += time;
}
