// Walls that hold rigid bodies: entities with SegmentWall or PlaneWall, which the kernels read (kernels/solver/2d/walls.ts).
import { rigidKernels } from '../collision/kernels.ts';
import { keyOf } from '../components/all.ts';
import { bitOf } from '../components/membership.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { reportFault } from '../errors/report-fault.ts';
import {
  WallColumnsWord as Column,
  SHAPE_BYTES,
  WALL_COLUMNS_BYTES,
  RigidTableWord as Word,
} from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

const WALLS = ['SegmentWall', 'PlaneWall'] as const;

interface WallLists {
  readonly SegmentWall: EntityList;
  readonly PlaneWall: EntityList;
  /** Walls that were reported because a number of theirs is not finite. */
  readonly reported: Set<number>;
}

const wallLists = namedResource('wall lists of rigid bodies', (world): WallLists => {
  const { SegmentWall, PlaneWall } = world.addresses;
  const { at, words } = allocateRecord(world.internal.arena, WALL_COLUMNS_BYTES, 'walls');
  words[Column.ax] = SegmentWall.ax;
  words[Column.ay] = SegmentWall.ay;
  words[Column.bx] = SegmentWall.bx;
  words[Column.by] = SegmentWall.by;
  words[Column.segmentRestitution] = SegmentWall.restitution;
  words[Column.segmentFriction] = SegmentWall.friction;
  words[Column.nx] = PlaneWall.nx;
  words[Column.ny] = PlaneWall.ny;
  words[Column.offset] = PlaneWall.offset;
  words[Column.planeRestitution] = PlaneWall.restitution;
  words[Column.planeFriction] = PlaneWall.friction;
  rigidTable(world).words[Word.wallColumns] = at;
  return { SegmentWall: emptyEntityList(), PlaneWall: emptyEntityList(), reported: new Set() };
});

/**
 * Brings the list of walls up to date, and reports each wall that is left out because a number of it is not finite.
 * @throws PhysicsError E_RANGE for an entity that is a wall and a body, or two walls; E_CAPACITY
 */
export function refreshWalls(world: PhysicsWorld): void {
  const { counts } = world.internal;
  if (counts.SegmentWall === 0 && counts.PlaneWall === 0) return;
  const lists = wallLists(world);
  const bytes = SHAPE_BYTES[world.precision];
  for (const name of WALLS) {
    const list = lists[name];
    if (refreshEntityList(world, list, name, bytes + 4)) {
      // The records are multiples of 4 bytes, behind the ids; reals of f64 start at a multiple of 8.
      const shapes = Math.ceil(list.at / 8) * 8;
      checkEntities(world, list, name);
      rigidKernels(world).assignWallShapes(rigidTable(world).at, list.ids, list.count, shapes, bytes);
    }
    reportInvalid(world, list, name, lists.reported);
  }
}

function checkEntities(world: PhysicsWorld, list: EntityList, name: (typeof WALLS)[number]): void {
  const { members } = world.internal;
  for (const id of new Uint32Array(world.memory.buffer, list.ids, list.count)) {
    const other = (['Position', ...WALLS] as const).find(
      (component) => component !== name && (members[id] & bitOf(component)) !== 0,
    );
    if (other === undefined) continue;
    list.version = -1;
    throw new PhysicsError('E_RANGE', `entity ${id} has ${name} and ${other}, so that it is two things at once.`, {
      entity: id,
      field: keyOf(name),
      hint: 'Give the wall an entity of its own.',
    });
  }
}

/** Reports each wall once, and again only after it was corrected. */
function reportInvalid(
  world: PhysicsWorld,
  list: EntityList,
  name: (typeof WALLS)[number],
  reported: Set<number>,
): void {
  if (rigidKernels(world).countInvalidWalls(rigidTable(world).at, list.ids, list.count) === 0 && reported.size === 0)
    return;
  const columns: Readonly<Record<string, ArrayLike<number>>> = world.components[name];
  for (const entity of new Uint32Array(world.memory.buffer, list.ids, list.count)) {
    const field = Object.keys(columns).find((key) => !Number.isFinite(columns[key][entity]));
    if (field === undefined) {
      reported.delete(entity);
    } else if (!reported.has(entity)) {
      reported.add(entity);
      const value = columns[field][entity];
      reportFault(world, { code: 'E_NONFINITE', entity, field: `${name}.${field}`, value, phase: 'begin' });
    }
  }
}
