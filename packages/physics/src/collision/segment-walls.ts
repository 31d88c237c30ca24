// Walls that are straight segments (2D), each an entity with SegmentWall. kernels/walls/segments.ts has the maths.
import { bitOf } from '../components/all';
import type { LocalSystem } from '../schedule/phases';
import { allocate } from '../store/arena';
import { realBytes } from '../store/columns';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';
import { collisionKernels } from './kernels';

/** Cells of the walls' grid along one axis, at most; and entries of its lists for each wall. */
const MOST_SIDE = 64;
const ITEMS_A_WALL = 16;

/** The words of `WallGrid` in kernels/walls/wall-grid.ts. */
enum GridWord {
  count,
  segments,
  starts,
  items,
  mostItems,
  side,
  /** How many there are. */
  end,
}

interface SegmentList {
  readonly grid: number;
  /** Walls there is room for. */
  room: number;
  ids: number;
  tick: number;
  membership: number;
  count: number;
}

const segmentList = resource<SegmentList>((world) => {
  const { arena } = world.internal;
  const grid = allocate(arena, 4 * GridWord.end, 'segment walls');
  writeGrid(world, grid, GridWord.starts, allocate(arena, 4 * (MOST_SIDE * MOST_SIDE + 2), 'segment walls'));
  return { grid, room: 0, ids: 0, tick: -1, membership: -1, count: 0 };
});

function writeGrid(world: PhysicsWorld, grid: number, word: GridWord, value: number): void {
  new Uint32Array(world.memory.buffer, grid, GridWord.end)[word] = value;
}

/** Makes room for all walls, twice as much as before: the arena gives nothing back. @throws PhysicsError E_CAPACITY */
function reserve(world: PhysicsWorld, list: SegmentList, count: number): void {
  if (count <= list.room) return;
  let room = Math.max(64, list.room);
  while (room < count) room *= 2;
  const { arena } = world.internal;
  const size = 12 * realBytes(world.precision);
  list.ids = allocate(arena, 4 * room, 'segment walls');
  writeGrid(world, list.grid, GridWord.segments, allocate(arena, size * room, 'segment walls'));
  writeGrid(world, list.grid, GridWord.items, allocate(arena, 4 * ITEMS_A_WALL * room, 'segment walls'));
  writeGrid(world, list.grid, GridWord.mostItems, ITEMS_A_WALL * room);
  list.room = room;
}

/** Gathers the walls, once a step, in ascending id. */
function gather(world: PhysicsWorld): SegmentList {
  const list = segmentList(world);
  if (list.tick === world.tick) return list;
  const { kernels, internal, addresses, versions, lastId } = world;
  reserve(world, list, internal.counts.SegmentWall);
  if (list.membership !== versions.membership) {
    list.count = kernels.listIds(internal.membersAt, bitOf('SegmentWall'), lastId + 1, list.ids);
    list.membership = versions.membership;
  }
  const { ax, ay, bx, by, restitution, friction } = addresses.SegmentWall;
  collisionKernels(world).gatherSegments(list.grid, list.ids, list.count, ax, ay, bx, by, restitution, friction);
  list.tick = world.tick;
  return list;
}

/**
 * System of the `walls` phase: bodies with Mass and Collider against every SegmentWall. A contact's restitution is the
 * larger of the body's and the wall's, its friction coefficient the geometric mean. No speed takes a body through.
 */
export const segmentWalls: LocalSystem = {
  name: 'segment walls',
  usesScratch: true,
  run(world, spans, dt) {
    if (world.dimensions !== 2 || world.internal.counts.SegmentWall === 0) return;
    const { grid } = gather(world);
    const { previousAddresses, scratch, integrator } = world;
    const kernels = collisionKernels(world);
    const { x, y } = previousAddresses.Position;
    const start = scratch.at.startVelocity;
    const lag = (integrator.velocityLag ?? 0) * dt;
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r] as number;
      kernels.segmentWalls(grid, x, y, start.x, start.y, dt, lag, first, spans.bounds[2 * r + 1] as number);
    }
  },
};

/** Keeps bodies that contacts pushed in this step on their side of the segment walls. */
export function confineToSegments(world: PhysicsWorld): void {
  collisionKernels(world).confineToSegments(gather(world).grid);
}
