// Walls that are straight segments (2D), each an entity with SegmentWall. kernels/particle-contacts/walls/segments.ts has the maths.

import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { forEachRange } from '../ecs/ranges.ts';
import { reportFault } from '../errors/report-fault.ts';
import { allocate } from '../memory/arena.ts';
import { SEGMENT_BYTES, WALL_GRID_BYTES, WallGridWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { resource } from '../memory/resource.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { collisionKernels } from './kernels.ts';

/** Cells of the walls' grid along one axis, at most; and entries of its lists for each wall. */
const MAX_SIDE = 64;
const ITEMS_A_WALL = 16;

interface SegmentList extends EntityList {
  readonly grid: number;
  readonly words: Uint32Array;
  /** The step they were gathered in. */
  tick: number;
  /** Walls that were reported because an end of theirs is not finite. */
  readonly reported: Set<number>;
}

const segmentList = resource<SegmentList>((world) => {
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

/** Gathers the walls, once a step, in ascending id. */
function gather(world: PhysicsWorld): SegmentList {
  const list = segmentList(world);
  if (list.tick === world.tick) return list;
  const size = SEGMENT_BYTES[world.precision];
  if (refreshEntityList(world, list, 'SegmentWall', size + 4 * ITEMS_A_WALL)) {
    const { words, at, room } = list;
    words[Word.segments] = at;
    words[Word.items] = at + size * room;
    words[Word.mostItems] = ITEMS_A_WALL * room;
  }
  collisionKernels(world).gatherSegments(list.grid, list.ids, list.count);
  list.tick = world.tick;
  if (list.words[Word.count] < list.count) reportBadWalls(world, list);
  else if (list.reported.size > 0) list.reported.clear();
  return list;
}

/** Reports each wall that was left out, once until it is put right. */
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
 * System of the `walls` phase: bodies with Mass and Collider against every SegmentWall. A contact's restitution is the
 * larger of the body's and the wall's, its friction coefficient the geometric mean. No speed takes a body through.
 */
export const segmentWalls: LocalSystem = {
  name: 'segment walls',
  run: forEachRange((world, first, last, dt) => {
    if (world.dimensions !== 2 || world.internal.counts.SegmentWall === 0) return;
    const { grid } = gather(world);
    const lag = (world.integrator.velocityLag ?? 0) * dt;
    collisionKernels(world).segmentWalls(grid, dt, lag, first, last);
  }),
};

/** Keeps bodies that contacts pushed in this step on their side of the segment walls. */
export function confineToSegments(world: PhysicsWorld): void {
  collisionKernels(world).confineToSegments(gather(world).grid);
}
