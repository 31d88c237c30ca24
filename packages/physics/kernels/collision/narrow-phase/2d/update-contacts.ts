// The narrow phase: brings the manifold of every contact up to date, and drops contacts whose boxes no longer overlap.
//
// Recycling: a manifold is kept while neither body has turned by more than 11 degrees since it was found, and no point of
// one has moved by 0.05 m against the other (0.02 m while they do not touch, so that no touch is missed, or touch with a
// single point: the other corner of a box that tips over was at least that far away; 0.0005 m on a segment of a chain, on which what
// slides has another point soon), nor slid along it to where another corner takes part, or by 0.005 m if that is more: what has slid over an
// edge would rest beyond it. Only its normal and its separations change, these by the same formula as within sub-steps, and its points
// go with the corners that they are. Source, but for the normal, corners, single points and chains: Box2D 3.2 (physics_world.c).
//
//   separation = that found + n · (movement of b's anchor - movement of a's)       n turns with an edge, or the heavier body
import { columns } from '../../../memory/columns';
import {
  ASLEEP,
  CHANGED,
  DYNAMIC,
  ENLARGED,
  FAST,
  GROUPED,
  MOVES,
  NEWLY_ONE_WAY,
  ONE_WAY,
  PART,
  SENSOR,
  WAKES,
  WALL,
  flagsOf,
  isActive,
  poseOf,
  putFlags,
  putWord,
  word,
} from '../../../solver/2d/body';
import { forgetImpulses } from '../../../solver/2d/forget-impulses';
import { listAwake } from '../../../solver/2d/gather-bodies';
import { clearEvents, noteEnd, noteSensorPairEnd } from '../../../solver/2d/contact-events';
import { wakeForced, wakeIsland, wakeSprung } from '../../../solver/2d/islands';
import { bodyOf } from '../../../solver/2d/parts';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { shapeAt } from '../../../solver/2d/walls';
import { overlaps, rowBox } from '../../broad-phase/2d/fat-boxes';
import { areJoined, filtersMeet, firstOf, kindsMeet, layersMeet, secondOf } from '../../broad-phase/2d/pair-filter';
import { keyAt, putKey } from '../../broad-phase/2d/sort-keys';
import { SHAPE_BYTES, Shape } from '../../shapes/2d/shape';
import { areDiscs } from './collide-ahead';
import { collideShapes } from './collide-shapes';
import { freeContact, isCurrent, moveEntry, sensorFlags } from './contact-list';
import { SPECULATIVE_DISTANCE, dropFarPoints, foreseeDiscs, mayStop, reachOf } from './far-points';
import { Manifold, setPoses } from './manifold';
import { moveToMiddle } from './mid-step';
import { mixMaterials } from './mix-materials';
import { moveAnchors } from './move-anchors';
import { passesThrough } from './one-way';
import {
  CORNERS_SHIFT,
  ContactPoint,
  FORESEEN,
  FOUND,
  IGNORED,
  KEPT,
  OF_MANIFOLD,
  ON_CHAIN,
  OVERLAPS,
  PASSING,
  RigidContact,
  SENSES,
  SENSOR_IS_B,
  SETTLED,
  TOUCHING,
  WAS_TOUCHING,
  contactAt,
  contactInOrder,
  isSettled,
  pointOf,
  slotInOrder,
} from './rigid-contact';
import { coverSeams } from './seams';
import { updateSensor } from './sensor-overlap';

const RECYCLE_DISTANCE: real = 0.05;
const CHAIN_DISTANCE: real = 0.0005;
const RECYCLE_COSINE: real = 0.98;

const manifold = changetype<Manifold>(memory.data(offsetof<Manifold>() + 16, 16));
const spareA = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
const spareB = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// Wakes the islands that other forces act on, that something awake touches or pulls at by a spring, or that lie on what is gone, before
// contacts are updated.
export function wakeIslands(table: usize): void {
  const t = changetype<RigidTable>(table);
  if (t.asleepCount == 0) return;
  let any = wakeForced(t);
  for (let i = 0; i < t.contactCount; i++) {
    const key = keyAt(t.keys, i);
    const flagsA = flagsOf(t, firstOf(key));
    const flagsB = flagsOf(t, secondOf(key));
    if (((flagsA | flagsB) & ASLEEP) == 0) continue;
    const mayMove = isActive(flagsA) || isActive(flagsB);
    if (!mayMove && (t.changedCount == 0 || !mayEnd(t, flagsA | flagsB))) continue;
    const contact = contactInOrder(t, i);
    if ((contact.flags & (SENSES | IGNORED | PASSING)) != 0) continue;
    const touched = (contact.flags & TOUCHING) != 0;
    const isEnding = ((flagsA | flagsB) & SENSOR) != 0 || isOver(t, contact);
    // What does not move meets what sleeps where it begins to collide.
    const mayMeet = mayMove || (!touched && ((flagsA | flagsB) & CHANGED) != 0);
    if (!isEnding && !mayMeet) continue;
    if (!isEnding) findManifold(t, contact);
    if (!touched && (isEnding || contact.count == 0)) continue;
    wakeBody(t, contact.bodyA);
    wakeBody(t, contact.bodyB);
    any = true;
  }
  if (wakeSprung(t) || any) listAwake(t);
}

// Whether a contact of shapes that do not move may end, or change its kind: these are the flags of either. The box of a part changes
// where the part is moved within its body.
// @ts-ignore: decorator
@inline function mayEnd(t: RigidTable, flags: u32): bool {
  return (flags & (CHANGED | ENLARGED)) != 0 || t.isUnsettled != 0;
}

// @ts-ignore: decorator
@inline function wakeBody(t: RigidTable, body: i32): void {
  if ((flagsOf(t, body) & ASLEEP) != 0) wakeIsland(t, body);
}

export function updateContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  let kept = 0;
  let current = 0;
  groundCount = 0;
  clearEvents(t);
  if (t.changedKindCount + t.lighterCount > 0) forgetImpulses(t);
  for (let i = 0; i < t.contactCount; i++) {
    const key = keyAt(t.keys, i);
    const flagsA = flagsOf(t, firstOf(key));
    const flagsB = flagsOf(t, secondOf(key));
    const isAwake = isActive(flagsA) || isActive(flagsB);
    if (!isAwake && isSettled(t, i) && !mayEnd(t, flagsA | flagsB)) {
      moveEntry(t, i, kept++);
      continue;
    }
    const slot = slotInOrder(t, i);
    const contact = contactAt(t, slot);
    if (isOver(t, contact)) {
      endContact(t, contact);
      freeContact(t, slot);
      continue;
    }
    const before = contact.flags;
    if (updateContact(t, contact)) putWord(t.touching, 2 * groundCount++, slot);
    putWord(t.order, kept, !isAwake && contact.flags == before ? slot | SETTLED : slot);
    putKey(t.keys, kept++, key);
    putWord(t.current, current++, slot);
  }
  t.contactCount = kept;
  t.currentCount = current;
  t.isUnsettled = 0;
  if (groundCount > 1) coverSeams(t, groundCount);
}

function endContact(t: RigidTable, contact: RigidContact): void {
  if ((contact.flags & TOUCHING) != 0) {
    wakeLater(t, contact);
    noteEnd(t, contact);
  } else if ((contact.flags & OVERLAPS) != 0) {
    noteSensorPairEnd(t, contact);
  }
}

// One of the shapes became a sensor, or is none any more; with other flags of sensors, the other one is it now.
function changeKind(t: RigidTable, contact: RigidContact, flags: u32): void {
  endContact(t, contact);
  if (flags == 0 || (contact.flags & SENSES) == 0) wakeLater(t, contact);
  contact.count = 0;
  contact.rollingImpulse = 0;
  contact.flags = (contact.flags & IGNORED) | flags;
}

// Flags of shapes that are not plain.
const SPECIAL: u32 = SENSOR | GROUPED | WALL | PART;

function isOver(t: RigidTable, contact: RigidContact): bool {
  const a = contact.a;
  const b = contact.b;
  const flagsA = flagsOf(t, a);
  const flagsB = flagsOf(t, b);
  if (!overlaps(rowBox(t, a), rowBox(t, b))) return true;
  // Nearly all contacts are of two bodies of one shape each that only layers can keep apart.
  const isPlain = ((flagsA | flagsB) & SPECIAL) == 0 && contact.bodyA == a && contact.bodyB == b;
  if (!isPlain || ((flagsA | flagsB) & DYNAMIC) == 0) {
    if (!kindsMeet(flagsA, flagsB) || !filtersMeet(t, a, b)) return true;
    if (contact.bodyA != bodyOf(t, a) || contact.bodyB != bodyOf(t, b)) return true;
  } else if (!layersMeet(t, a, b)) return true;
  if (areJoined(t, contact.bodyA, contact.bodyB)) return true;
  return !isCurrent(t, contact);
}

// What lay on something that is gone wakes in the next step.
function wakeLater(t: RigidTable, contact: RigidContact): void {
  for (let side = 0; side < 2; side++) {
    const row = side == 0 ? contact.bodyA : contact.bodyB;
    if ((flagsOf(t, row) & ASLEEP) != 0) putFlags(t, row, flagsOf(t, row) | WAKES);
  }
}

// Contacts that touch, of a dynamic body with one that is static or kinematic.
let groundCount: i32 = 0;

// Returns whether the contact is one of those.
function updateContact(t: RigidTable, contact: RigidContact): bool {
  const flagsA = flagsOf(t, contact.a);
  const flagsB = flagsOf(t, contact.b);
  const sensing = ((flagsA | flagsB) & SENSOR) != 0 ? sensorFlags(t, contact) : 0;
  if ((contact.flags & (SENSES | SENSOR_IS_B)) != sensing) changeKind(t, contact, sensing);
  if ((contact.flags & IGNORED) != 0) return false;
  if ((contact.flags & SENSES) != 0) {
    updateSensor(t, contact, isActive(flagsA) || isActive(flagsB));
    return false;
  }
  const touched = (contact.flags & TOUCHING) != 0;
  const kept = (contact.flags & KEPT) | (touched ? WAS_TOUCHING : 0);
  if (!isActive(flagsA) && !isActive(flagsB)) {
    contact.flags = kept | (touched ? TOUCHING : contact.flags & PASSING);
    return false;
  }
  const passed = (contact.flags & PASSING) != 0;
  contact.flags = kept;
  const isRecycled = ((flagsA | flagsB) & FAST) == 0 && mayRecycle(t, contact, touched) && recycle(t, contact);
  if (!isRecycled) findManifold(t, contact);
  if (contact.count == 0) return false;
  const isOpen = !touched || ((flagsA | flagsB) & NEWLY_ONE_WAY) != 0;
  if (isOpen && ((flagsA | flagsB) & ONE_WAY) != 0 && (passed || passesThrough(t, contact))) {
    contact.flags |= PASSING;
    return false;
  }
  contact.flags |= TOUCHING;
  if (!isRecycled) moveAnchors(t, contact, false);
  // Each step, because friction or the speed of a conveyor may change while the points are kept.
  mixMaterials(t, contact);
  return ((flagsA & DYNAMIC) == 0) != ((flagsB & DYNAMIC) == 0);
}

// Returns false if the manifold must be found again after all.
function recycle(t: RigidTable, contact: RigidContact): bool {
  if (contact.count == 0) return true;
  return moveAnchors(t, contact, true) && !mayStop(t, contact);
}

function mayRecycle(t: RigidTable, contact: RigidContact, touched: bool): bool {
  const c = columns();
  const shapeA = <u32>word(c.shape, contact.a);
  const shapeB = <u32>word(c.shape, contact.b);
  // A circle turns without changing what it touches, and is cheap.
  if ((contact.flags & FOUND) == 0 || shapeA == 0 || shapeB == 0) return false;
  if (shapeA != contact.shapeA || shapeB != contact.shapeB) return false;
  const a = poseOf(t, contact.a);
  const b = poseOf(t, contact.b);
  const cosA = a.c * contact.ac + a.s * contact.as;
  const cosB = b.c * contact.bc + b.s * contact.bs;
  if (min<real>(cosA, cosB) <= RECYCLE_COSINE) return false;
  const sinA = a.s * contact.ac - a.c * contact.as;
  const sinB = b.s * contact.bc - b.c * contact.bs;
  // The vector between the centres, as b moved in the frame of a.
  const x = b.x - a.x - (cosA * contact.dx - sinA * contact.dy);
  const y = b.y - a.y - (sinA * contact.dx + cosA * contact.dy);
  const turn = abs<real>(sinB * cosA - cosB * sinA);
  const extentA = (flagsOf(t, contact.a) & MOVES) != 0 ? a.extent : <real>0;
  const extentB = (flagsOf(t, contact.b) & MOVES) != 0 ? b.extent : <real>0;
  const moved = sqrt<real>(x * x + y * y) + max<real>(extentA, extentB) * turn;
  if ((contact.flags & ON_CHAIN) != 0) return moved < CHAIN_DISTANCE;
  const limit = touched && contact.count == 2 ? RECYCLE_DISTANCE : SPECULATIVE_DISTANCE;
  return moved < limit;
}

function findManifold(t: RigidTable, contact: RigidContact): void {
  const m = manifold;
  const a = poseOf(t, contact.a);
  const b = poseOf(t, contact.b);
  setPoses(m, b.x - a.x, b.y - a.y, a.c, a.s, b.c, b.s);
  const near = COINCIDENT * min<real>(a.minExtent, b.minExtent);
  if (m.bx * m.bx + m.by * m.by < near * near) spread(m, contact.a, contact.b, near);
  m.speculative = reachOf(t, contact);
  m.reach = Infinity;
  const c = columns();
  contact.shapeA = <u32>word(c.shape, contact.a);
  contact.shapeB = <u32>word(c.shape, contact.b);
  const shapeA = shapeAt(t, contact.a, spareA);
  const shapeB = shapeAt(t, contact.b, spareB);
  contact.ac = a.c;
  contact.as = a.s;
  contact.bc = b.c;
  contact.bs = b.s;
  let isLeftOut = false;
  if (!areDiscs(t, contact) || !foreseeDiscs(t, contact, m, shapeA, shapeB)) {
    moveToMiddle(t, contact, m, shapeA, shapeB);
    collideShapes(m, shapeA, shapeB);
    isLeftOut = dropFarPoints(t, contact, m, shapeA, shapeB);
  }
  contact.dx = m.bx;
  contact.dy = m.by;
  // A predicted manifold is computed again in the next step, and so is one that was left out because of how fast the two were.
  if (isLeftOut || (contact.flags & FORESEEN) != 0) contact.flags &= ~FOUND;
  else contact.flags |= FOUND;
  contact.flags = (contact.flags & ~OF_MANIFOLD) | (m.corners << CORNERS_SHIFT);
  contact.room = m.room;
  if (m.count == 1) contact.flags |= m.edge;
  if ((shapeA.isChained | shapeB.isChained) != 0) contact.flags |= ON_CHAIN;
  takePoints(t, contact, m);
}

// Bodies whose centres are nearer, in parts of the least extent, lie in one place.
const COINCIDENT: real = 0.001;

// The first numbers of the sequence R2, which fills a square evenly: Roberts, The unreasonable effectiveness of quasirandom
// sequences (2018).
const R2_X: f64 = 0.7548776662466927;
const R2_Y: f64 = 0.5698402909980532;

// Bodies in one place have no normal, and would all take the same: a heap of a hundred then left as a column of a hundred
// layers, each faster than the one below. They are taken to lie evenly in a tiny square instead, by their ids.
function spread(m: Manifold, a: i32, b: i32, size: real): void {
  m.bx = size * <real>(fraction(R2_X * <f64>b) - fraction(R2_X * <f64>a));
  m.by = size * <real>(fraction(R2_Y * <f64>b) - fraction(R2_Y * <f64>a));
}

// @ts-ignore: decorator
@inline function fraction(x: f64): f64 {
  return x - Math.floor(x);
}

// Points with the id of an earlier one go on with its impulses.
function takePoints(t: RigidTable, contact: RigidContact, m: Manifold): void {
  const first = pointOf(contact, 0);
  const second = pointOf(contact, 1);
  const oldCount = contact.count;
  const old0 = oldCount > 0 ? <u32>contact.id0 : NO_POINT;
  const old1 = oldCount > 1 ? <u32>contact.id1 : NO_POINT;
  const n0 = first.normalImpulse;
  const t0 = first.tangentImpulse;
  const n1 = second.normalImpulse;
  const t1 = second.tangentImpulse;
  contact.count = <i16>m.count;
  contact.foundNx = contact.nx = m.nx;
  contact.foundNy = contact.ny = m.ny;
  contact.id0 = <u16>m.id0;
  contact.id1 = <u16>m.id1;
  takePoint(first, m.x0, m.y0, m.separation0);
  takePoint(second, m.x1, m.y1, m.separation1);
  moveToBodies(t, contact, m);
  first.normalImpulse = m.id0 == old0 ? n0 : m.id0 == old1 ? n1 : <real>0;
  first.tangentImpulse = m.id0 == old0 ? t0 : m.id0 == old1 ? t1 : <real>0;
  second.normalImpulse = m.id1 == old0 ? n0 : m.id1 == old1 ? n1 : <real>0;
  second.tangentImpulse = m.id1 == old0 ? t0 : m.id1 == old1 ? t1 : <real>0;
  if (m.count == 0) contact.rollingImpulse = 0;
}

// No feature has this id.
const NO_POINT: u32 = 0xffffffff;

// @ts-ignore: decorator
@inline function takePoint(p: ContactPoint, x: real, y: real, separation: real): void {
  p.foundAx = x;
  p.foundAy = y;
  p.foundSeparation = separation;
}

// Points, which are given from the centre of the shape a, become anchors from the centres of mass of both bodies.
function moveToBodies(t: RigidTable, contact: RigidContact, m: Manifold): void {
  let ax: real = 0;
  let ay: real = 0;
  let bx = m.bx;
  let by = m.by;
  if (contact.bodyA != contact.a) {
    ax = poseOf(t, contact.bodyA).x - poseOf(t, contact.a).x;
    ay = poseOf(t, contact.bodyA).y - poseOf(t, contact.a).y;
  }
  if (contact.bodyB != contact.b) {
    bx += poseOf(t, contact.bodyB).x - poseOf(t, contact.b).x;
    by += poseOf(t, contact.bodyB).y - poseOf(t, contact.b).y;
  }
  for (let i = 0; i < contact.count; i++) {
    const p = pointOf(contact, i);
    p.foundBx = p.foundAx - bx;
    p.foundBy = p.foundAy - by;
    p.foundAx -= ax;
    p.foundAy -= ay;
  }
}
