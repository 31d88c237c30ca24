// Seams between things that contacts do not move, such as the tiles of a floor or of a lift. A body that slides or rolls over
// them meets the corner or the side of the next tile before its top, with a normal that the surface of all tiles together does
// not have, and would be thrown up. Such a contact with S is left to the contact with S', which touches the same body, where
//
//   all its points on S are in S', too,
//   S' has something in front of them along the normal of S, so that this is no normal of both together,
//   S stays behind the plane of the contact with S': what that keeps in front of the plane does not enter S.
//
// The third holds no body back from a wall that stands on a floor, or from a step. The idea of features that are void because
// a neighbour covers them is that of Jolt Physics (InternalEdgeRemovingCollector.h), the condition on normals that of convex
// analysis: a normal of a union is one of each part that has the point.
import { DYNAMIC, flagsOf, poseOf, putWord, word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { shapeAt } from '../../../solver/2d/walls';
import { SHAPE_BYTES, Shape, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { COVERED, FOUND, RigidContact, contactAt, pointOf } from './rigid-contact';

// Surfaces that differ by less are flush, m: a fifth of the slop.
const FLUSH: real = 0.001;

const spare = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// Covers contacts of the first `count` entries of t.touching, which are slots of contacts of a dynamic body with one that is
// not: 2 words each, the second of which is for the next entry of the same shape. Colors of rows are not in use yet.
export function coverSeams(t: RigidTable, count: i32): void {
  for (let i = 0; i < count; i++) putWord(t.usedColors, moverOf(t, entryAt(t, i)), -1);
  for (let i = 0; i < count; i++) {
    const mover = moverOf(t, entryAt(t, i));
    putWord(t.touching, 2 * i + 1, word(t.usedColors, mover));
    putWord(t.usedColors, mover, i);
  }
  for (let i = 0; i < count; i++) {
    const contact = entryAt(t, i);
    const first = word(t.usedColors, moverOf(t, contact));
    // Nearly all bodies on a floor touch one thing that does not move.
    if (first == i && word(t.touching, 2 * i + 1) < 0) continue;
    const depth = nearest(contact);
    for (let k = first; k >= 0; k = word(t.touching, 2 * k + 1)) {
      const other = entryAt(t, k);
      // What covers is as near, and nearer if it is covered itself, so that two contacts do not cover each other.
      const limit = (other.flags & COVERED) == 0 ? depth + FLUSH : depth - FLUSH;
      if (k == i || nearest(other) > limit || !covers(t, other, contact)) continue;
      cover(contact);
      break;
    }
  }
}

// @ts-ignore: decorator
@inline function entryAt(t: RigidTable, i: i32): RigidContact {
  return contactAt(t, word(t.touching, 2 * i));
}

// @ts-ignore: decorator
@inline function isMoverA(t: RigidTable, contact: RigidContact): bool {
  return (flagsOf(t, contact.a) & DYNAMIC) != 0;
}

// @ts-ignore: decorator
@inline function moverOf(t: RigidTable, contact: RigidContact): i32 {
  return isMoverA(t, contact) ? contact.a : contact.b;
}

// The least distance of the surfaces.
// @ts-ignore: decorator
@inline function nearest(contact: RigidContact): real {
  const first = pointOf(contact, 0).separation;
  return contact.count == 1 ? first : min<real>(first, pointOf(contact, 1).separation);
}

// A contact that is covered is found anew in the next step, and starts without impulses when it counts again.
function cover(contact: RigidContact): void {
  contact.flags = (contact.flags & ~FOUND) | COVERED;
  contact.rollingImpulse = 0;
  for (let i = 0; i < contact.count; i++) {
    const point = pointOf(contact, i);
    point.normalImpulse = 0;
    point.tangentImpulse = 0;
    point.totalImpulse = 0;
    point.normalSpeed = 0;
  }
}

// The side of a contact that is not dynamic: row of its shape, outward normal there, and a point of its surface in the world.
let row: i32 = 0;
let nx: real = 0;
let ny: real = 0;
let x: real = 0;
let y: real = 0;

function takeSide(t: RigidTable, contact: RigidContact): void {
  const isB = isMoverA(t, contact);
  row = isB ? contact.b : contact.a;
  nx = isB ? -contact.nx : contact.nx;
  ny = isB ? -contact.ny : contact.ny;
}

// Anchors are half-way between the surfaces as they were found, and what does not move has not turned since.
function takePoint(t: RigidTable, contact: RigidContact, i: i32): void {
  const isB = row == contact.b;
  const pose = poseOf(t, isB ? contact.bodyB : contact.bodyA);
  const point = pointOf(contact, i);
  const half = <real>0.5 * point.foundSeparation;
  x = pose.x + (isB ? point.bx : point.ax) - half * nx;
  y = pose.y + (isB ? point.by : point.ay) - half * ny;
}

// Whether `contact` is left to `by`.
function covers(t: RigidTable, by: RigidContact, contact: RigidContact): bool {
  takeSide(t, by);
  const otherRow = row;
  const otherX = nx;
  const otherY = ny;
  takePoint(t, by, 0);
  let planeX = x;
  let planeY = y;
  if (by.count > 1) {
    takePoint(t, by, 1);
    if ((x - planeX) * nx + (y - planeY) * ny > 0) {
      planeX = x;
      planeY = y;
    }
  }
  takeSide(t, contact);
  if (reach(t, row, otherX, otherY, planeX, planeY) > FLUSH) return false;
  for (let i = 0; i < contact.count; i++) {
    takePoint(t, contact, i);
    if (distance(t, otherRow, x, y) > FLUSH || reach(t, otherRow, nx, ny, x, y) <= FLUSH) return false;
  }
  return true;
}

// How far a shape reaches beyond a point along a direction, infinite for half-planes and segments of chains.
function reach(t: RigidTable, body: i32, dx: real, dy: real, fromX: real, fromY: real): real {
  const shape = shapeAt(t, body, spare);
  if (shape.isChained != 0) return Infinity;
  const pose = poseOf(t, body);
  const localX = pose.c * dx + pose.s * dy;
  const localY = pose.c * dy - pose.s * dx;
  let most = localX * vertexX(shape, 0) + localY * vertexY(shape, 0);
  for (let i = 1; i < shape.count; i++) most = max<real>(most, localX * vertexX(shape, i) + localY * vertexY(shape, i));
  return most + shape.radius - ((fromX - pose.x) * dx + (fromY - pose.y) * dy);
}

// The distance of a point from a shape, less than 0 inside; beyond a corner a little less than it is.
function distance(t: RigidTable, body: i32, atX: real, atY: real): real {
  const shape = shapeAt(t, body, spare);
  if (shape.isChained != 0) return Infinity;
  const pose = poseOf(t, body);
  const localX = pose.c * (atX - pose.x) + pose.s * (atY - pose.y);
  const localY = pose.c * (atY - pose.y) - pose.s * (atX - pose.x);
  if (shape.count < 3) return coreDistance(shape, localX, localY) - shape.radius;
  let most = -(<real>Infinity);
  for (let i = 0; i < shape.count; i++) {
    const away = (localX - vertexX(shape, i)) * normalX(shape, i) + (localY - vertexY(shape, i)) * normalY(shape, i);
    most = max<real>(most, away);
  }
  return most - shape.radius;
}

// The distance of a point from the core of a disc, a capsule or a segment.
function coreDistance(shape: Shape, atX: real, atY: real): real {
  const last = shape.count - 1;
  const edgeX = vertexX(shape, last) - vertexX(shape, 0);
  const edgeY = vertexY(shape, last) - vertexY(shape, 0);
  const fromX = atX - vertexX(shape, 0);
  const fromY = atY - vertexY(shape, 0);
  const square = edgeX * edgeX + edgeY * edgeY;
  const part = square > 0 ? min<real>(max<real>((fromX * edgeX + fromY * edgeY) / square, 0), 1) : <real>0;
  const offX = fromX - part * edgeX;
  const offY = fromY - part * edgeY;
  return sqrt<real>(offX * offX + offY * offY);
}
