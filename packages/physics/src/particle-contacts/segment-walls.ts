// Walls that are line segments (2D), each an entity with SegmentWall. The formulas are in
// kernels/particle-contacts/walls/segments.ts.

import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { forEachRange } from '../ecs/ranges.ts';
import { allocate } from '../memory/arena.ts';
import { realBytes } from '../memory/columns.ts';
import { resource } from '../memory/resource.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { collisionKernels } from './kernels.ts';

/** Maximum number of grid cells along one axis, and of list entries per wall. */
const MAX_SIDE = 64;
const ITEMS_PER_WALL = 16;

/** The words of `WallGrid` in kernels/particle-contacts/walls/wall-grid.ts. */
const enum GridWord {
  count,
  segments,
  starts,
  items,
  mostItems,
  side,
  /** The number of words. */
  end,
}

interface SegmentList extends EntityList {
  readonly grid: number;
  readonly words: Uint32Array;
  /** The step in which the walls were gathered. */
  tick: number;
}

const segmentList = resource<SegmentList>((world) => {
  const { arena } = world.internal;
  const grid = allocate(arena, 4 * GridWord.end, 'segment walls');
  const words = new Uint32Array(world.memory.buffer, grid, GridWord.end);
  words[GridWord.starts] = allocate(arena, 4 * (MAX_SIDE * MAX_SIDE + 2), 'segment walls');
  return { grid, words, tick: -1, ...emptyEntityList() };
});

/** Gathers the walls in ascending id, once per step. */
function gather(world: PhysicsWorld): SegmentList {
  const list = segmentList(world);
  if (list.tick === world.tick) return list;
  const size = 12 * realBytes(world.precision);
  if (refreshEntityList(world, list, 'SegmentWall', size + 4 * ITEMS_PER_WALL)) {
    const { words, at, room } = list;
    words[GridWord.segments] = at;
    words[GridWord.items] = at + size * room;
    words[GridWord.mostItems] = ITEMS_PER_WALL * room;
  }
  const { ax, ay, bx, by, restitution, friction } = world.addresses.SegmentWall;
  collisionKernels(world).gatherSegments(list.grid, list.ids, list.count, ax, ay, bx, by, restitution, friction);
  list.tick = world.tick;
  return list;
}

/**
 * System of the `walls` phase: collides bodies with Mass and Collider against every SegmentWall. The restitution of a
 * contact is the larger of the body's and the wall's, its friction coefficient their geometric mean. Bodies do not
 * tunnel at any speed.
 */
export const segmentWalls: LocalSystem = {
  name: 'segment walls',
  run: forEachRange((world, first, last, dt) => {
    if (world.dimensions !== 2 || world.internal.counts.SegmentWall === 0) return;
    const { grid } = gather(world);
    const { x, y } = world.previousAddresses.Position;
    const start = world.scratch.at.startVelocity;
    const lag = (world.integrator.velocityLag ?? 0) * dt;
    collisionKernels(world).segmentWalls(grid, x, y, start.x, start.y, dt, lag, first, last);
  }),
};

/** Keeps bodies that contacts moved in this step on their side of the segment walls. */
export function confineToSegments(world: PhysicsWorld): void {
  collisionKernels(world).confineToSegments(gather(world).grid);
}
