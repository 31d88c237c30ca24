// Begins a step: which rows are bodies of the solver, their poses, and their velocities, gathered from the columns.
import { Columns, columns, get, put } from '../../memory/columns';
import { clearRecord } from '../../memory/records';
import { sineCosine } from '../../math/elementary';
import { CIRCLE, SHAPE_BYTES, Shape } from '../../collision/shapes/2d/shape';
import { shapeOf } from '../../collision/shapes/2d/shape-pool';
import { emptyBox, isForgotten, rowBox } from '../../collision/broad-phase/2d/fat-boxes';
import {
  ASLEEP,
  BodyPose,
  CHANGED,
  CHANGED_KIND,
  COLLIDES,
  COMPOUND,
  DYNAMIC,
  FAST,
  KINEMATIC,
  LIGHTER,
  LOCKED,
  MAY_MOVE,
  MOVES,
  NEWLY_ONE_WAY,
  ONE_WAY,
  PART,
  ROUND,
  SENSOR,
  SHIFTED,
  SLEEPLESS,
  STANDS,
  STATIC,
  WAKES,
  WALL,
  flagsOf,
  poseOf,
  putFlags,
  putWord,
  stateOf,
  word,
} from './body';
import { colliderFlags, filterOf, findColliderFlags } from './collider-flags';
import { wakeIsland, wasDisturbed } from './islands';
import { listLocked } from './motion-locks';
import { kindOfPart, linkParts, placeParts, turnTo } from './parts';
import { RigidTable } from './rigid-table';
import { GROUP, isPassed, passOver, settle } from './settled-rows';
import { hasNewCollider, recordCollider, sleeperOf } from './sleeper';
import { isValidWall, placeWall } from './walls';

// What a body keeps from step to step.
const KEPT: u32 = ASLEEP | FAST;

// Where the circle of a body without a shape of the pool is written.
const spare = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));

// Classifies all rows, and lists the bodies that move and are awake. User code may have changed any column between the steps.
export function gatherBodies(table: usize): void {
  const t = changetype<RigidTable>(table);
  t.sleptCount = 0;
  t.wokenCount = 0;
  t.sensorCount = 0;
  t.movingSensorCount = 0;
  t.mayMoveCount = 0;
  t.changedCount = 0;
  t.changedKindCount = 0;
  t.lighterCount = 0;
  findColliderFlags(t);
  // Entities that are gone may have left rows at the end.
  const end = max<i32>(t.rows, t.lastRows);
  t.lastRows = t.rows;
  const c = columns();
  for (let first = 0; first < end; first += GROUP) if (!passOver(c, t, first)) classifyGroup(c, t, first, end);
  if (t.partCount > 0) classifyParts(t);
  list(t, true);
  for (let first = 0; first < end; first += GROUP) settle(c, t, first);
}

function classifyGroup(c: Columns, t: RigidTable, first: i32, end: i32): void {
  for (let row = max<i32>(first, 1); row < min<i32>(first + GROUP, end); row++) {
    if ((<u32>word(t.members, row) & t.attachmentBit) == 0) classify(t, row, kindOf(c, t, row));
  }
}

// Parts come after all bodies, because they are of the kind of theirs.
function classifyParts(t: RigidTable): void {
  linkParts(t);
  for (let i = 0; i < t.partCount; i++) {
    const row = word(t.partIds, i);
    const kind = kindOfPart(t, row);
    const body = kind == 0 ? 0 : word(t.attachmentBody, row);
    if (word(t.owners, row) != body) leaveBody(t, row);
    putWord(t.owners, row, body);
    const changed = classify(t, row, kind);
    const isOpened = (flagsOf(t, row) & NEWLY_ONE_WAY) != 0;
    if (!changed && !isOpened && (kind == 0 || !hasNewCollider(t, row))) continue;
    if (kind != 0) putFlags(t, row, flagsOf(t, row) | SHIFTED);
    recordCollider(t, row);
    if ((flagsOf(t, body) & ASLEEP) != 0) wakeIsland(t, body);
  }
}

// What a part belonged to wakes, and what it touched is found anew.
function leaveBody(t: RigidTable, row: i32): void {
  const owner = word(t.owners, row);
  if (owner == 0) return;
  t.isUnsettled = 1;
  t.changedCount++;
  if ((flagsOf(t, owner) & (ASLEEP | PART)) == ASLEEP) wakeIsland(t, owner);
  invalidateTrees(t, flagsOf(t, row));
  // The extents of the body are found anew, too.
  if ((flagsOf(t, owner) & STATIC) != 0) emptyBox(rowBox(t, owner));
  putWord(t.owners, row, 0);
  putFlags(t, row, 0);
  forgetBox(t, row);
}

// Lists the bodies that move and are awake anew, after some woke in this step.
export function listAwake(t: RigidTable): void {
  list(t, false);
}

// Lists the bodies that move and are awake, with their poses and velocities. What users have moved or changed since the last step
// is told by records that are overwritten here, and so only the first time in a step.
function list(t: RigidTable, isFirst: bool): void {
  const c = columns();
  // Row 0 is the world, to which joints may hold a body.
  rest(t, 0);
  poseOf(t, 0).c = 1;
  let awake = 0;
  t.asleepCount = 0;
  for (let row = 1; row < t.rows; row++) {
    if ((row & (GROUP - 1)) == 0 && isPassed(t, row)) {
      row += GROUP - 1;
      continue;
    }
    const flags = flagsOf(t, row);
    if ((flags & ASLEEP) != 0) t.asleepCount++;
    if ((flags & (MOVES | STATIC)) == 0 || (flags & (ASLEEP | PART)) != 0) continue;
    if ((flags & STATIC) != 0) {
      if (!isFirst) continue;
      if ((flags & WALL) != 0) {
        placeWall(t, row);
        continue;
      }
      if ((flags & COMPOUND) == 0 && isUnchanged(c, t, row)) continue;
    } else if (isFirst && (flags & KINEMATIC) != 0) {
      if ((<u32>word(c.members, row) & t.lockBit) != 0) stopLocked(c, t, row);
      watchKinematic(c, t, row);
    }
    readPose(c, t, row);
    readExtents(t, row);
    if ((flags & MOVES) == 0) continue;
    readVelocity(c, t, row);
    putWord(t.awake, awake++, row);
  }
  t.awakeCount = awake;
  listLocked(t);
  if (t.partCount > 0) placeParts(t);
}

// Whether pose and collider of a static body are those of the last step. A body without a box is new, or collides with
// nothing.
function isUnchanged(c: Columns, t: RigidTable, row: i32): bool {
  return !isForgotten(rowBox(t, row)) && isWhereItWas(c, t, row) && !hasNewCollider(t, row);
}

// @ts-ignore: decorator
@inline function isWhereItWas(c: Columns, t: RigidTable, row: i32): bool {
  const pose = poseOf(t, row);
  if (get(c.positionX, row) != pose.x || get(c.positionY, row) != pose.y) return false;
  return get(t.angle, row) == sleeperOf(t, row).angle;
}

// A kinematic body keeps no velocity along a locked axis either.
function stopLocked(c: Columns, t: RigidTable, row: i32): void {
  if (word(t.lockX, row) != 0) put(c.velocityX, row, 0);
  if (word(t.lockY, row) != 0) put(c.velocityY, row, 0);
  if (word(t.lockAngle, row) != 0) put(c.angularVelocityZ, row, 0);
}

// What lies on a kinematic body that stands may sleep.
function watchKinematic(c: Columns, t: RigidTable, row: i32): void {
  const hasShape = (flagsOf(t, row) & COLLIDES) != 0;
  const stands = !isDriven(c, row) && (hasShape ? isUnchanged(c, t, row) : isWhereItWas(c, t, row));
  if (stands) putFlags(t, row, flagsOf(t, row) | STANDS);
}

// Returns whether the row has another body than in the last step, or one that collides otherwise.
function classify(t: RigidTable, row: i32, kind: u32): bool {
  if ((flagsOf(t, row) & PART) != 0 && (kind & PART) == 0) leaveBody(t, row);
  const before = flagsOf(t, row) & ~CHANGED;
  const same = kind != 0 && word(t.bodyGenerations, row) == word(t.generations, row);
  const changed = !same || ((before ^ kind) & KINDS) != 0 || ((kind & COLLIDES) != 0 && hasNewFilter(t, row));
  if (
    (before & (ASLEEP | PART)) == ASLEEP &&
    (changed || (before & WAKES) != 0 || (kind & SLEEPLESS) != 0 || wasDisturbed(t, row, kind))
  )
    wakeIsland(t, row);
  if ((kind & SENSOR) != 0) {
    t.sensorCount++;
    if ((kind & MOVES) != 0) t.movingSensorCount++;
  }
  if ((kind & MAY_MOVE) != 0) t.mayMoveCount++;
  putFlags(t, row, kind | (changed ? 0 : flagsOf(t, row) & KEPT));
  if (same && ((before ^ kind) & DYNAMIC) != 0) {
    putFlags(t, row, flagsOf(t, row) | CHANGED_KIND);
    t.changedKindCount++;
  }
  if (!changed && (kind & ~before & ONE_WAY) != 0) noteOneWay(t, row);
  putWord(t.bodyGenerations, row, word(t.generations, row));
  if (!changed || (before | kind) == 0) return false;
  t.changedCount++;
  putFlags(t, row, flagsOf(t, row) | CHANGED);
  if (word(t.firstParts, row) != 0) t.isUnsettled = 1;
  putWord(t.filters, row, filterOf(t, row));
  invalidateTrees(t, before);
  invalidateTrees(t, kind);
  forgetBox(t, row);
  // What an earlier body of this row touched does not tell whether this one flies.
  putWord(t.usedColors, row, 0);
  sleeperOf(t, row).stillFor = 0;
  return true;
}

// What touches it from below or beside passes from now on, asleep or not.
function noteOneWay(t: RigidTable, row: i32): void {
  if ((flagsOf(t, row) & (ASLEEP | PART)) == ASLEEP) wakeIsland(t, row);
  putFlags(t, row, flagsOf(t, row) | NEWLY_ONE_WAY | SHIFTED);
}

// Pairs whose boxes overlap already are found anew when layers, masks or groups change.
// @ts-ignore: decorator
@inline function hasNewFilter(t: RigidTable, row: i32): bool {
  return word(t.filters, row) != filterOf(t, row);
}

// The tree that such a body is in, or should be in, is made anew.
// @ts-ignore: decorator
@inline function invalidateTrees(t: RigidTable, flags: u32): void {
  if ((flags & COLLIDES) == 0) return;
  if ((flags & STATIC) != 0) t.staticTreeValid = 0;
  if ((flags & MOVES) != 0) t.movingTreeValid = 0;
}

// @ts-ignore: decorator
@inline function isLocked(t: RigidTable, row: i32): bool {
  return (word(t.lockX, row) | word(t.lockY, row) | word(t.lockAngle, row)) != 0;
}

const KINDS: u32 = MOVES | STATIC | MAY_MOVE | COLLIDES | PART | SENSOR | WALL;

// @ts-ignore: decorator
@inline function kindOf(c: Columns, t: RigidTable, row: i32): u32 {
  const bits = <u32>word(c.members, row);
  // Position is the first component: its bit is 1.
  if ((bits & 1) == 0) return (bits & (t.segmentWallBit | t.planeWallBit)) != 0 ? kindOfWall(t, row) : 0;
  const collides: u32 = (bits & t.colliderBit) != 0 && hasShape(c, row) ? COLLIDES | colliderFlags(t, row) : 0;
  const kind = collides | ((bits & t.neverSleepBit) != 0 ? SLEEPLESS : 0);
  if ((bits & t.kinematicBit) != 0) return KINEMATIC | kind;
  if ((bits & t.dynamicBits) == t.dynamicBits && get(c.mass, row) > 0) {
    return DYNAMIC | kind | ((bits & t.lockBit) != 0 && isLocked(t, row) ? LOCKED : 0);
  }
  // Without a shape it is still what a joint may hang from.
  if (isDriven(c, row)) return KINEMATIC | kind;
  return STATIC | kind | ((bits & t.velocityBits) != 0 ? MAY_MOVE : 0);
}

// A circle of radius 0 is none: what touched it would stand on a point. Particles that are not born or have ended are such.
// @ts-ignore: decorator
@inline function hasShape(c: Columns, row: i32): bool {
  return get(c.radius, row) > 0 || word(c.shape, row) != 0;
}

function kindOfWall(t: RigidTable, row: i32): u32 {
  return isValidWall(t, row) ? STATIC | COLLIDES | WALL : 0;
}

// What has no mass moves by its velocity, whatever acts on it.
// @ts-ignore: decorator
@inline function isDriven(c: Columns, row: i32): bool {
  return get(c.velocityX, row) != 0 || get(c.velocityY, row) != 0 || get(c.angularVelocityZ, row) != 0;
}

// Empties the fat boxes of a body and of its parts.
export function forgetBox(t: RigidTable, row: i32): void {
  emptyBox(rowBox(t, row));
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) emptyBox(rowBox(t, part));
}

function rest(t: RigidTable, row: i32): void {
  const state = stateOf(t, row);
  clearRecord(changetype<usize>(state), 8 * sizeof<real>());
  state.dc = 1;
}

export function readPose(c: Columns, t: RigidTable, row: i32): void {
  const pose = poseOf(t, row);
  const flags = flagsOf(t, row);
  turnTo(<f64>get(t.angle, row));
  if ((flags & STATIC) != 0 && (hasMoved(c, pose, row) || ((flags & COLLIDES) != 0 && hasNewCollider(t, row))))
    putFlags(t, row, flags | SHIFTED);
  sleeperOf(t, row).angle = get(t.angle, row);
  pose.x = get(c.positionX, row);
  pose.y = get(c.positionY, row);
  pose.c = <real>sineCosine.cosine;
  pose.s = <real>sineCosine.sine;
  const before = pose.inverseMass;
  pose.inverseMass = 0;
  pose.inverseInertia = 0;
  if ((flags & DYNAMIC) != 0) {
    const inertia = get(c.inertia, row);
    const mayTurn = (flags & LOCKED) == 0 || word(t.lockAngle, row) == 0;
    const turns = mayTurn && inertia > 0 && (<u32>word(c.members, row) & t.turningBits) == t.turningBits;
    pose.inverseMass = <real>1 / get(c.mass, row);
    pose.inverseInertia = turns ? <real>1 / inertia : <real>0;
    if (before > 0 && before < pose.inverseMass) noteLighter(t, row, before);
  }
}

function noteLighter(t: RigidTable, row: i32, before: real): void {
  sleeperOf(t, row).formerInverseMass = before;
  putFlags(t, row, flagsOf(t, row) | LIGHTER);
  t.lighterCount++;
}

// Of a body without a shape of its own, `placeParts` finds them.
function readExtents(t: RigidTable, row: i32): void {
  const pose = poseOf(t, row);
  if ((flagsOf(t, row) & COLLIDES) == 0) {
    pose.extent = 0;
    pose.minExtent = <real>Infinity;
    return;
  }
  recordCollider(t, row);
  const shape = shapeOf(row, spare);
  pose.extent = shape.extent;
  pose.minExtent = shape.minExtent;
  if (shape.kind == CIRCLE) putFlags(t, row, flagsOf(t, row) | ROUND);
}

// @ts-ignore: decorator
@inline function hasMoved(c: Columns, pose: BodyPose, row: i32): bool {
  if (get(c.positionX, row) != pose.x || get(c.positionY, row) != pose.y) return true;
  return <real>sineCosine.cosine != pose.c || <real>sineCosine.sine != pose.s;
}

// Reads the velocities of a body. Kinematic bodies move and turn by them although they have no mass and no inertia.
function readVelocity(c: Columns, t: RigidTable, row: i32): void {
  rest(t, row);
  const state = stateOf(t, row);
  state.vx = get(c.velocityX, row);
  state.vy = get(c.velocityY, row);
  const turns = (flagsOf(t, row) & KINEMATIC) != 0 || poseOf(t, row).inverseInertia > 0;
  state.w = turns ? get(c.angularVelocityZ, row) : <real>0;
  if ((flagsOf(t, row) & LOCKED) == 0) return;
  if (word(t.lockX, row) != 0) state.vx = 0;
  if (word(t.lockY, row) != 0) state.vy = 0;
}
