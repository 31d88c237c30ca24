// Islands: bodies that touch or are joined, directly or through others. What does not move connects nothing. An island falls
// asleep when all its bodies have been still for a while (still-bodies.ts), and wakes as a whole. Source: Box2D 3 (island.c,
// solver_set.c).
import { columns, get, put } from '../../memory/columns';
import { RigidContact, contactAt, pointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import {
  ASLEEP,
  COLLIDES,
  DYNAMIC,
  KINEMATIC,
  MOVES,
  PART,
  STANDS,
  TO_SLEEP,
  WAKES,
  flagsOf,
  isActive,
  poseOf,
  putFlags,
  putWord,
  stateOf,
  word,
} from './body';
import { readPose } from './gather-bodies';
import { locksOf } from './motion-locks';
import { bodyOf, placePart } from './parts';
import { RigidTable } from './rigid-table';
import { Sleeper, hasNewCollider, sleeperOf } from './sleeper';
import {
  HELD,
  TOUCHES,
  countStill,
  freeAcceleration,
  haveForcesChanged,
  heldAcceleration,
  noteForces,
  restsFor,
} from './still-bodies';

// Ends a step: counts how long bodies have been still, and lets islands sleep.
export function updateSleep(table: usize): void {
  const t = changetype<RigidTable>(table);
  if (t.sleepTime <= 0) return;
  if (!countStill(t)) return;
  joinIslands(t);
  sleepIslands(t);
}

function joinIslands(t: RigidTable): void {
  for (let i = 0; i < t.touchingCount; i++) {
    const contact = contactAt(t, word(t.touching, 2 * i));
    joinBodies(t, contact.bodyA, contact.bodyB);
    sleeperOf(t, contact.bodyA).holds |= TOUCHES;
    sleeperOf(t, contact.bodyB).holds |= TOUCHES;
    if (contact.tangentSpeed == 0 || !carries(t, contact)) continue;
    sleeperOf(t, contact.bodyA).stillFor = 0;
    sleeperOf(t, contact.bodyB).stillFor = 0;
  }
  for (let i = 0; i < t.linkCount; i++) joinBodies(t, word(t.links, 2 * i), word(t.links, 2 * i + 1));
  // A spring holds nothing in its place, but what pulls at one end feels the other.
  for (let i = 0; i < t.springCount; i++) {
    joinAwake(t, springEnd(t, i, 0), springEnd(t, i, 1));
  }
}

// For pictures: the islands of all bodies, as they are after the step. Steps find them only when something may fall asleep.
export function labelIslands(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    if ((flagsOf(t, row) & ASLEEP) == 0) sleeperOf(t, row).island = row;
  }
  for (let i = 0; i < t.touchingCount; i++) {
    const contact = contactAt(t, word(t.touching, 2 * i));
    joinAwake(t, contact.bodyA, contact.bodyB);
  }
  for (let i = 0; i < t.linkCount; i++) joinAwake(t, word(t.links, 2 * i), word(t.links, 2 * i + 1));
  for (let i = 0; i < t.springCount; i++) joinAwake(t, springEnd(t, i, 0), springEnd(t, i, 1));
}

function joinAwake(t: RigidTable, a: i32, b: i32): void {
  if ((flagsOf(t, a) & flagsOf(t, b) & DYNAMIC) == 0) return;
  if (((flagsOf(t, a) | flagsOf(t, b)) & ASLEEP) == 0) joinBodies(t, a, b);
}

// The smallest id of the island of a body or of a part, 0 for what is in none.
export function islandAt(table: usize, row: i32): i32 {
  const t = changetype<RigidTable>(table);
  const body = bodyOf(t, row);
  return (flagsOf(t, body) & DYNAMIC) == 0 ? 0 : islandOf(t, body);
}

// Whether a belt carries what it presses: that goes at more than half of the speed of the surface. What is held back by something
// else slips, and may sleep.
function carries(t: RigidTable, contact: RigidContact): bool {
  const point = pointOf(contact, 0);
  if (point.totalImpulse == 0 && (contact.count < 2 || pointOf(contact, 1).totalImpulse == 0)) return false;
  const along =
    tangentSpeedOf(t, contact, contact.bodyB, point.bx, point.by) -
    tangentSpeedOf(t, contact, contact.bodyA, point.ax, point.ay);
  return <real>2 * (along / contact.tangentSpeed) > 1;
}

// The speed of a point of a body along the tangent (n_y, -n_x), m/s.
function tangentSpeedOf(t: RigidTable, contact: RigidContact, row: i32, x: real, y: real): real {
  if ((flagsOf(t, row) & MOVES) == 0) return 0;
  const state = stateOf(t, row);
  return contact.ny * state.vx - contact.nx * state.vy - state.w * (contact.nx * x + contact.ny * y);
}

// What a kinematic body carries stays awake as long as that moves.
function joinBodies(t: RigidTable, a: i32, b: i32): void {
  const kindA = flagsOf(t, a);
  const kindB = flagsOf(t, b);
  if ((kindA & kindB & DYNAMIC) == 0) {
    sleeperOf(t, a).holds |= HELD;
    sleeperOf(t, b).holds |= HELD;
    if ((kindA & (KINEMATIC | STANDS)) == KINEMATIC) sleeperOf(t, b).stillFor = 0;
    if ((kindB & (KINEMATIC | STANDS)) == KINEMATIC) sleeperOf(t, a).stillFor = 0;
    return;
  }
  const islandA = islandOf(t, a);
  const islandB = islandOf(t, b);
  if (islandA < islandB) sleeperOf(t, islandB).island = islandA;
  else sleeperOf(t, islandA).island = islandB;
}

// The first body of an island, by paths that are halved on the way.
export function islandOf(t: RigidTable, row: i32): i32 {
  let at = row;
  while (sleeperOf(t, at).island != at) {
    const above = sleeperOf(t, at);
    above.island = sleeperOf(t, above.island).island;
    at = above.island;
  }
  return at;
}

// An island has been still for as long as the body that moved last. What nothing holds must have been at rest besides.
function sleepIslands(t: RigidTable): void {
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const first = sleeperOf(t, islandOf(t, row));
    const sleeper = sleeperOf(t, row);
    if (sleeper.stillFor < first.stillFor) first.stillFor = sleeper.stillFor;
    if (sleeper.steadyFor < first.steadyFor) first.steadyFor = sleeper.steadyFor;
    if (sleeper.freeFor < first.freeFor) first.freeFor = sleeper.freeFor;
    first.holds |= sleeper.holds;
    sleeper.next = row;
  }
  putIslandsToSleep(t);
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const island = islandOf(t, row);
    const first = sleeperOf(t, island);
    if ((flagsOf(t, row) & DYNAMIC) == 0 || <f64>restsFor(first) < t.sleepTime) continue;
    fallAsleep(t, row, first);
    if (row == island) continue;
    // The ring grows behind its first body.
    sleeperOf(t, row).next = first.next;
    first.next = row;
  }
}

// Islands that are put to sleep do not wait until they are still.
function putIslandsToSleep(t: RigidTable): void {
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    if ((flagsOf(t, row) & TO_SLEEP) == 0) continue;
    putFlags(t, row, flagsOf(t, row) & ~TO_SLEEP);
    const first = sleeperOf(t, islandOf(t, row));
    first.stillFor = <real>Infinity;
    first.holds = HELD | TOUCHES;
  }
}

function fallAsleep(t: RigidTable, row: i32, first: Sleeper): void {
  const c = columns();
  put(c.velocityX, row, 0);
  put(c.velocityY, row, 0);
  put(c.angularVelocityZ, row, 0);
  putFlags(t, row, flagsOf(t, row) | ASLEEP);
  putWord(t.slept, t.sleptCount++, row);
  readPose(c, t, row);
  for (let part = word(t.firstParts, row); part != 0; part = word(t.nextParts, part)) placePart(t, part, row);
  const sleeper = sleeperOf(t, row);
  sleeper.angle = get(t.angle, row);
  sleeper.locks = locksOf(t, row, flagsOf(t, row));
  sleeper.isStopped = first.stillFor == <real>Infinity ? 1 : 0;
  sleeper.wakingAcceleration = (first.holds & HELD) != 0 ? heldAcceleration(t) : freeAcceleration(t);
  noteForces(t, row, sleeper);
}

// Whether a sleeping body was moved, left or unlocked since it fell asleep. Its flags are those of this step.
// @ts-ignore: decorator
@inline export function wasDisturbed(t: RigidTable, row: i32, flags: u32): bool {
  const c = columns();
  const pose = poseOf(t, row);
  if (get(c.positionX, row) != pose.x || get(c.positionY, row) != pose.y) return true;
  if (get(t.angle, row) != sleeperOf(t, row).angle) return true;
  if ((flagsOf(t, row) & COLLIDES) != 0 && hasNewCollider(t, row)) return true;
  if (locksOf(t, row, flags) != sleeperOf(t, row).locks) return true;
  return get(c.velocityX, row) != 0 || get(c.velocityY, row) != 0 || get(c.angularVelocityZ, row) != 0;
}

// Wakes all bodies of a sleeping island.
export function wakeIsland(t: RigidTable, row: i32): void {
  let at = row;
  do {
    const flags = flagsOf(t, at);
    if ((flags & ASLEEP) != 0) putWord(t.woken, t.wokenCount++, at);
    putFlags(t, at, flags & ~(ASLEEP | WAKES));
    const sleeper: Sleeper = sleeperOf(t, at);
    sleeper.stillFor = 0;
    at = sleeper.next;
  } while (at != row);
}

// Wakes the bodies on which other forces act than when they fell asleep. Returns whether anything woke.
export function wakeForced(t: RigidTable): bool {
  let any = false;
  for (let row = 1; row < t.rows; row++) {
    if ((flagsOf(t, row) & (ASLEEP | PART)) != ASLEEP || !haveForcesChanged(t, row)) continue;
    wakeIsland(t, row);
    any = true;
  }
  return any;
}

// Wakes what springs connect with something that moves. Returns whether anything woke.
export function wakeSprung(t: RigidTable): bool {
  let any = false;
  for (let i = 0; i < t.springCount; i++) {
    const a = springEnd(t, i, 0);
    const b = springEnd(t, i, 1);
    const flagsA = flagsOf(t, a);
    const flagsB = flagsOf(t, b);
    if (((flagsA | flagsB) & ASLEEP) == 0 || !(isActive(flagsA) || isActive(flagsB))) continue;
    wakeIsland(t, (flagsA & ASLEEP) != 0 ? a : b);
    any = true;
  }
  return any;
}

// The body at an end of a spring.
// @ts-ignore: decorator
@inline function springEnd(t: RigidTable, i: i32, end: i32): i32 {
  return bodyOf(t, word(t.springs, 3 * i + 1 + end));
}
