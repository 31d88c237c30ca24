// The fat box of a body: an axis-aligned box about its shape with a margin, so that it stays while the body moves a little.
//
//   margin = min(0.05 m, extent / 8)
//
// Source: the margin is that of Box2D 3 (constants.h).
import { SPECULATIVE_DISTANCE } from '../../narrow-phase/2d/far-points';
import { PLANE, SHAPE_BYTES, Shape, vertexX, vertexY } from '../../shapes/2d/shape';
import {
  ASLEEP,
  COLLIDES,
  ENLARGED,
  MOVES,
  PART,
  ROUND,
  SHIFTED,
  STATIC,
  flagsOf,
  poseOf,
  putFlags,
  stateOf,
  word,
} from '../../../solver/2d/body';
import { bodyOf } from '../../../solver/2d/parts';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { GROUP, isPassed } from '../../../solver/2d/settled-rows';
import { shapeAt } from '../../../solver/2d/walls';

@unmanaged
export class FatBox {
  minX: real;
  minY: real;
  maxX: real;
  maxY: real;
}

// Turns a box inside out, so that no box is inside it and it overlaps nothing.
export function emptyBox(box: FatBox): void {
  box.minX = Infinity;
  box.minY = Infinity;
  box.maxX = -Infinity;
  box.maxY = -Infinity;
}

// @ts-ignore: decorator
@inline export function copyBox(to: FatBox, from: FatBox): void {
  to.minX = from.minX;
  to.minY = from.minY;
  to.maxX = from.maxX;
  to.maxY = from.maxY;
}

const MARGIN: real = 0.05;
const MARGIN_FRACTION: real = 0.125;

const spare = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// The tight box about a shape, as `measureBox` leaves it.
export const tight = changetype<FatBox>(memory.data(offsetof<FatBox>() + sizeof<real>(), 8));

// @ts-ignore: decorator
@inline export function rowBox(t: RigidTable, row: i32): FatBox {
  return changetype<FatBox>(t.boxes + <usize>row * (4 * sizeof<real>()));
}

// Whether a box is inside out, because its body is new or is gone.
// @ts-ignore: decorator
@inline export function isForgotten(box: FatBox): bool {
  return box.minX > box.maxX;
}

// All four comparisons at once: which of them fails is hard to predict.
// @ts-ignore: decorator
@inline export function overlaps(a: FatBox, b: FatBox): bool {
  const leastA = v128.load(changetype<usize>(a));
  const leastB = v128.load(changetype<usize>(b));
  if (sizeof<real>() == 4) {
    const least = v128.shuffle<u64>(leastA, leastB, 0, 2);
    const most = v128.shuffle<u64>(leastB, leastA, 1, 3);
    return i32x4.bitmask(f32x4.le(least, most)) == 15;
  }
  const mostA = v128.load(changetype<usize>(a), 16);
  const mostB = v128.load(changetype<usize>(b), 16);
  return i64x2.bitmask(v128.and(f64x2.le(leastA, mostB), f64x2.le(leastB, mostA))) == 3;
}

// Gives every body that left its fat box another, and counts these bodies.
export function updateBoxes(t: RigidTable): void {
  t.enlargedCount = 0;
  t.enlargedStatics = 0;
  for (let row = 1; row < t.rows; row++) {
    if ((row & (GROUP - 1)) == 0 && isPassed(t, row)) {
      row += GROUP - 1;
      continue;
    }
    const flags = flagsOf(t, row);
    if ((flags & COLLIDES) == 0 || (flags & ASLEEP) != 0) continue;
    const box = rowBox(t, row);
    if ((flags & (STATIC | SHIFTED | PART)) == STATIC && !isForgotten(box)) continue;
    const pose = poseOf(t, row);
    measureBox(shapeAt(t, row, spare), pose.x, pose.y, pose.c, pose.s);
    if ((flags & MOVES) != 0) addMotion(t, row);
    if (box.minX <= tight.minX && box.minY <= tight.minY && tight.maxX <= box.maxX && tight.maxY <= box.maxY) continue;
    const margin = min<real>(MARGIN, MARGIN_FRACTION * pose.extent);
    box.minX = tight.minX - margin;
    box.minY = tight.minY - margin;
    box.maxX = tight.maxX + margin;
    box.maxY = tight.maxY + margin;
    putFlags(t, row, flags | ENLARGED);
    t.enlargedCount++;
    if ((flags & STATIC) != 0) t.enlargedStatics++;
  }
}

// The box of what flies reaches as far as it may move in this step, where that is further than its margin: contacts see it
// coming (far-points.ts). What touched something in the last step is left out, for the margins of heaps that move would be
// filled with pairs, and so is what moves by more than a few times its extent, whose box would be in the way of all others. A function
// of the user must have been asked about whatever may stop the body in this step (solver/2d/continuous.ts), and so none is left out.
function addMotion(t: RigidTable, row: i32): void {
  const body = bodyOf(t, row);
  const asks = t.asksUser != 0;
  if (!asks && word(t.usedColors, body) != 0) return;
  const state = stateOf(t, body);
  const extent = poseOf(t, body).extent;
  const x = <real>t.dt * state.vx;
  const y = <real>t.dt * state.vy;
  const turn = <real>t.dt * abs<real>(state.w) * extent;
  const path = sqrt<real>(x * x + y * y) + turn;
  if (path <= min<real>(SPECULATIVE_DISTANCE, MARGIN_FRACTION * extent)) return;
  if (!asks && path > mostExtents(flagsOf(t, row)) * extent) return;
  tight.minX += min<real>(0, x - turn);
  tight.minY += min<real>(0, y - turn);
  tight.maxX += max<real>(0, x + turn);
  tight.maxY += max<real>(0, y + turn);
}

// The longest path of a step that is seen ahead, in extents of the body. For discs it costs less to find out what they meet.
const MOST_EXTENTS: real = 4;
const MOST_EXTENTS_OF_DISC: real = 8;

// @ts-ignore: decorator
@inline function mostExtents(flags: u32): real {
  return (flags & ROUND) != 0 ? MOST_EXTENTS_OF_DISC : MOST_EXTENTS;
}

// Writes the box about a shape at a pose to `tight`.
export function measureBox(shape: Shape, x: real, y: real, c: real, s: real): void {
  if (shape.kind == PLANE) return measurePlane(shape, x, y);
  let minX = <real>Infinity;
  let minY = <real>Infinity;
  let maxX = -minX;
  let maxY = -minY;
  for (let i = 0; i < shape.count; i++) {
    const vx = vertexX(shape, i);
    const vy = vertexY(shape, i);
    const px = c * vx - s * vy;
    const py = s * vx + c * vy;
    minX = min<real>(minX, px);
    maxX = max<real>(maxX, px);
    minY = min<real>(minY, py);
    maxY = max<real>(maxY, py);
  }
  tight.minX = x + minX - shape.radius;
  tight.minY = y + minY - shape.radius;
  tight.maxX = x + maxX + shape.radius;
  tight.maxY = y + maxY + shape.radius;
}

// As far as boxes reach: further than anything is, and the sum of two is finite.
const FAR: real = 1e30;

// A half-plane along an axis ends there; any other is everywhere.
function measurePlane(plane: Shape, x: real, y: real): void {
  tight.minX = plane.ny0 == 0 && plane.nx0 < 0 ? x : -FAR;
  tight.maxX = plane.ny0 == 0 && plane.nx0 > 0 ? x : FAR;
  tight.minY = plane.nx0 == 0 && plane.ny0 < 0 ? y : -FAR;
  tight.maxY = plane.nx0 == 0 && plane.ny0 > 0 ? y : FAR;
}
