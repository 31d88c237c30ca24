// Walls that are line segments (2D), each an entity with SegmentWall. The formulas are in
// kernels/particle-contacts/walls/segments.ts.

import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { forEachRange } from '../ecs/ranges.ts';
import { reportFault } from '../errors/report-fault.ts';
import { allocate } from '../memory/arena.ts';
import { SEGMENT_BYTES, WALL_GRID_BYTES, WallGridWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { beginImpacts } from './impact-list.ts';
import { collisionKernels } from './kernels.ts';
import { retakeRebounds } from './retake-rebounds.ts';

/** Maximum number of grid cells along one axis, and of list entries per wall. */
const MAX_SIDE = 64;
const ITEMS_PER_WALL = 16;

interface SegmentList extends EntityList {
  readonly grid: number;
  readonly words: Uint32Array;
  /** The step in which the walls were gathered. */
  tick: number;
  /** Walls that were reported because one of their ends is not finite. */
  readonly reported: Set<number>;
}

const segmentList = namedResource<SegmentList>('segment list', (world) => {
  const { arena } = world.internal;
  const { at: grid, words } = allocateRecord(arena, WALL_GRID_BYTES, 'segment walls');
  const { ax, ay, bx, by, restitution, friction } = world.addresses.SegmentWall;
  words.set([ax, ay, bx, by, restitution, friction], Word.ax);
  const { Position } = world.previousAddresses;
  const { startVelocity } = world.scratch.at;
  words.set([Position.x, Position.y, startVelocity.x, startVelocity.y], Word.previousX);
  words[Word.starts] = allocate(arena, 4 * (MAX_SIDE * MAX_SIDE + 2), 'segment walls');
  return { grid, words, tick: -1, reported: new Set<number>(), ...emptyEntityList() };
});

/** Gathers the walls in ascending id, once per step. */
function gather(world: PhysicsWorld): SegmentList {
  const list = segmentList(world);
  if (list.tick === world.tick) return list;
  const size = SEGMENT_BYTES[world.precision];
  if (refreshEntityList(world, list, 'SegmentWall', size + 4 * ITEMS_PER_WALL)) {
    const { words, at, capacity } = list;
    words[Word.segments] = at;
    words[Word.items] = at + size * capacity;
    words[Word.maxItems] = ITEMS_PER_WALL * capacity;
  }
  collisionKernels(world).gatherSegments(list.grid, list.ids, list.count);
  list.tick = world.tick;
  if (list.words[Word.count] < list.count) reportBadWalls(world, list);
  else if (list.reported.size > 0) list.reported.clear();
  return list;
}

/** Reports each wall that was omitted, and again only after it was corrected. */
function reportBadWalls(world: PhysicsWorld, { ids, count, reported }: SegmentList): void {
  const { SegmentWall } = world.components;
  const all = new Uint32Array(world.memory.buffer, ids, count);
  for (const entity of all) {
    const field = (['ax', 'ay', 'bx', 'by'] as const).find((name) => !Number.isFinite(SegmentWall[name][entity]));
    if (field === undefined) {
      reported.delete(entity);
    } else if (!reported.has(entity)) {
      reported.add(entity);
      const value = SegmentWall[field][entity];
      reportFault(world, { code: 'E_NONFINITE', entity, field: `SegmentWall.${field}`, value, phase: 'finish' });
    }
  }
}

/**
 * System of the `walls` phase: collides bodies with Mass and Collider against every SegmentWall. The restitution of a
 * contact is the larger of the body's and the wall's, its friction coefficient their geometric mean. Bodies do not
 * tunnel at any speed.
 */
export const segmentWalls: LocalSystem = {
  name: 'segment walls',
  handles: 'SegmentWall',
  run: forEachRange((world, first, last, dt) => {
    if (world.dimensions !== 2 || world.internal.counts.SegmentWall === 0) return;
    if (world.integrator.solvesWalls === true) return;
    const { grid } = gather(world);
    const lag = (world.integrator.velocityLag ?? 0) * dt;
    beginImpacts(world);
    collisionKernels(world).segmentWalls(grid, dt, lag, first, last);
    retakeRebounds(world, dt);
  }),
};

/** Keeps bodies that contacts moved in this step on their side of the segment walls. */
export function clampToSegments(world: PhysicsWorld): void {
  collisionKernels(world).clampToSegments(gather(world).grid);
}
