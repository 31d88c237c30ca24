// Walls that are no bodies: entities with SegmentWall or PlaneWall. Each has a shape of its own, made anew from its columns
// in every step, and counts as a static body; a segment lies about its middle, a half-plane about the foot of its normal.
import { get } from '../../memory/columns';
import { PLANE, SEGMENT, Shape } from '../../collision/shapes/2d/shape';
import { shapeOf } from '../../collision/shapes/2d/shape-pool';
import { makePlane, makeSegment } from '../../collision/shapes/2d/wall-shapes';
import { BodyPose, SHIFTED, WALL, flagsOf, poseOf, putFlags, putWord, word } from './body';
import { RigidTable } from './rigid-table';
import { sleeperOf } from './sleeper';
import { WallColumns } from './wall-columns';

// The shape of a body or of a wall.
// @ts-ignore: decorator
@inline export function shapeAt(t: RigidTable, row: i32, spare: Shape): Shape {
  if ((flagsOf(t, row) & WALL) == 0) return shapeOf(row, spare);
  return changetype<Shape>(<usize>word(t.wallShapes, row));
}

// @ts-ignore: decorator
@inline function isSegment(t: RigidTable, row: i32): bool {
  return (<u32>word(t.members, row) & t.segmentWallBit) != 0;
}

// Whether all numbers of a wall are finite, and a segment has a length or a plane a normal.
export function isValidWall(t: RigidTable, row: i32): bool {
  const w = changetype<WallColumns>(t.wallColumns);
  if (isSegment(t, row)) {
    const dx = get(w.bx, row) - get(w.ax, row);
    const dy = get(w.by, row) - get(w.ay, row);
    const square = dx * dx + dy * dy;
    return square > 0 && isFinite<real>(square) && isFinite<real>(get(w.ax, row)) && isFinite<real>(get(w.ay, row));
  }
  const nx = get(w.nx, row);
  const ny = get(w.ny, row);
  const square = nx * nx + ny * ny;
  return square > 0 && isFinite<real>(square) && isFinite<real>(get(w.offset, row));
}

// Brings shape and pose of a wall up to date.
export function placeWall(t: RigidTable, row: i32): void {
  const shape = changetype<Shape>(<usize>word(t.wallShapes, row));
  const pose = poseOf(t, row);
  const moved = isSegment(t, row) ? placeSegment(t, row, shape, pose) : placePlane(t, row, shape, pose);
  // What lies on a wall wakes when that has another friction.
  const friction = wallFriction(t, row);
  const sleeper = sleeperOf(t, row);
  if (moved || friction != sleeper.friction) putFlags(t, row, flagsOf(t, row) | SHIFTED);
  sleeper.friction = friction;
  pose.c = 1;
  pose.s = 0;
  pose.inverseMass = 0;
  pose.inverseInertia = 0;
  pose.extent = shape.extent;
  pose.minExtent = 0;
}

function placeSegment(t: RigidTable, row: i32, shape: Shape, pose: BodyPose): bool {
  const w = changetype<WallColumns>(t.wallColumns);
  const x = <real>0.5 * (get(w.ax, row) + get(w.bx, row));
  const y = <real>0.5 * (get(w.ay, row) + get(w.by, row));
  const halfX = get(w.bx, row) - x;
  const halfY = get(w.by, row) - y;
  const isSame = shape.kind == SEGMENT && shape.x1 == halfX && shape.y1 == halfY && pose.x == x && pose.y == y;
  if (isSame) return false;
  const half = sqrt<real>(halfX * halfX + halfY * halfY);
  makeSegment(shape, halfX, halfY, half);
  shape.isChained = 0;
  pose.x = x;
  pose.y = y;
  return true;
}

function placePlane(t: RigidTable, row: i32, shape: Shape, pose: BodyPose): bool {
  const w = changetype<WallColumns>(t.wallColumns);
  const length = sqrt<real>(get(w.nx, row) * get(w.nx, row) + get(w.ny, row) * get(w.ny, row));
  const nx = get(w.nx, row) / length;
  const ny = get(w.ny, row) / length;
  const x = get(w.offset, row) * nx;
  const y = get(w.offset, row) * ny;
  const isSame = shape.kind == PLANE && shape.nx0 == nx && shape.ny0 == ny && pose.x == x && pose.y == y;
  if (isSame) return false;
  makePlane(shape, nx, ny);
  // Pairs with it take the path of shapes that are rare.
  shape.isChained = 1;
  pose.x = x;
  pose.y = y;
  return true;
}

export function wallFriction(t: RigidTable, row: i32): real {
  const w = changetype<WallColumns>(t.wallColumns);
  return get(isSegment(t, row) ? w.segmentFriction : w.planeFriction, row);
}

export function wallRestitution(t: RigidTable, row: i32): real {
  const w = changetype<WallColumns>(t.wallColumns);
  return get(isSegment(t, row) ? w.segmentRestitution : w.planeRestitution, row);
}

// Gives every wall of a list the record of its shape: records of `bytes` from `shapes` on.
export function assignWallShapes(table: usize, ids: usize, count: i32, shapes: usize, bytes: i32): void {
  const t = changetype<RigidTable>(table);
  memory.fill(shapes, 0, <usize>count * <usize>bytes);
  for (let i = 0; i < count; i++) putWord(t.wallShapes, word(ids, i), <i32>(shapes + <usize>i * <usize>bytes));
}

// The number of walls of a list that are left out.
export function countInvalidWalls(table: usize, ids: usize, count: i32): i32 {
  const t = changetype<RigidTable>(table);
  let invalid = 0;
  for (let i = 0; i < count; i++) if (!isValidWall(t, word(ids, i))) invalid++;
  return invalid;
}
