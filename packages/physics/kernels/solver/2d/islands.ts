// Islands: bodies that touch or are joined, directly or through others. What does not move connects nothing. An island falls
// asleep when all its bodies have been still for a while, and wakes as a whole. Source: Box2D 3 (island.c, solver_set.c).
import { columns, get, put } from '../../memory/columns';
import { contactAt } from '../../collision/narrow-phase/2d/rigid-contact';
import {
  ASLEEP,
  COLLIDES,
  DYNAMIC,
  KINEMATIC,
  PART,
  SLEEPLESS,
  TO_SLEEP,
  WAKES,
  flagsOf,
  poseOf,
  putFlags,
  putWord,
  stateOf,
  word,
} from './body';
import { readPose } from './gather-bodies';
import { bodyOf, placePart } from './parts';
import { pathOf } from './paths';
import { RigidTable } from './rigid-table';
import { Sleeper, hasNewCollider, sleeperOf } from './sleeper';

// A change of acceleration, m/s², that wakes a body: in the time until it would sleep again it moves it faster than what
// counts as still.
const WAKING_ACCELERATION: real = 0.1;

// A body that gains more than this part of the speed that counts as still is not: where gravity is weak a block that begins to
// tip, or a ball at the top of its flight, is slow for longer than it takes to fall asleep. It may lose more, as piles do that
// settle.
const GAIN: real = 0.1;

// Ends a step: counts how long bodies have been still, and lets islands sleep.
export function updateSleep(table: usize): void {
  const t = changetype<RigidTable>(table);
  watchSleepers(t);
  if (t.sleepTime <= 0) return;
  if (!countStill(t)) return;
  joinIslands(t);
  sleepIslands(t);
}

// Whether any body has been still for long enough.
function countStill(t: RigidTable): bool {
  const dt = <real>t.dt;
  const limit = <real>t.sleepSpeed;
  const gain = GAIN * limit;
  let any = false;
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const sleeper = sleeperOf(t, row);
    const speed = speedOf(t, row);
    if (sleeper.stillFor == 0 || speed < sleeper.slowest) sleeper.slowest = speed;
    const still = (flagsOf(t, row) & SLEEPLESS) == 0 && speed <= limit && speed - sleeper.slowest <= gain;
    sleeper.stillFor = still ? sleeper.stillFor + dt : 0;
    sleeper.island = row;
    if (<f64>sleeper.stillFor >= t.sleepTime || (flagsOf(t, row) & TO_SLEEP) != 0) any = true;
  }
  return any;
}

// The larger of the speed of the fastest point and half the rate at which the body was displaced, m/s.
function speedOf(t: RigidTable, row: i32): real {
  const state = stateOf(t, row);
  const extent = poseOf(t, row).extent;
  const speed = sqrt<real>(state.vx * state.vx + state.vy * state.vy) + abs<real>(state.w) * extent;
  return max<real>(speed, (<real>0.5 * pathOf(t, row)) / <real>t.dt);
}

function joinIslands(t: RigidTable): void {
  for (let i = 0; i < t.touchingCount; i++) {
    const contact = contactAt(t, word(t.touching, 2 * i));
    joinBodies(t, contact.bodyA, contact.bodyB);
  }
  for (let i = 0; i < t.linkCount; i++) joinBodies(t, word(t.links, 2 * i), word(t.links, 2 * i + 1));
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
    labelPair(t, contact.bodyA, contact.bodyB);
  }
  for (let i = 0; i < t.linkCount; i++) labelPair(t, word(t.links, 2 * i), word(t.links, 2 * i + 1));
}

function labelPair(t: RigidTable, a: i32, b: i32): void {
  if ((flagsOf(t, a) & flagsOf(t, b) & DYNAMIC) == 0) return;
  if (((flagsOf(t, a) | flagsOf(t, b)) & ASLEEP) == 0) joinBodies(t, a, b);
}

// The smallest id of the island of a body or of a part, 0 for what is in none.
export function islandAt(table: usize, row: i32): i32 {
  const t = changetype<RigidTable>(table);
  const body = bodyOf(t, row);
  return (flagsOf(t, body) & DYNAMIC) == 0 ? 0 : islandOf(t, body);
}

// What a kinematic body carries stays awake as long as that moves.
function joinBodies(t: RigidTable, a: i32, b: i32): void {
  const kindA = flagsOf(t, a);
  const kindB = flagsOf(t, b);
  if ((kindA & kindB & DYNAMIC) == 0) {
    if ((kindA & KINEMATIC) != 0 && sleeperOf(t, a).stillFor == 0) sleeperOf(t, b).stillFor = 0;
    if ((kindB & KINEMATIC) != 0 && sleeperOf(t, b).stillFor == 0) sleeperOf(t, a).stillFor = 0;
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

// An island has been still for as long as the body that moved last.
function sleepIslands(t: RigidTable): void {
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const first = sleeperOf(t, islandOf(t, row));
    const sleeper = sleeperOf(t, row);
    if (sleeper.stillFor < first.stillFor) first.stillFor = sleeper.stillFor;
    sleeper.next = row;
  }
  putIslandsToSleep(t);
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const island = islandOf(t, row);
    const first = sleeperOf(t, island);
    if ((flagsOf(t, row) & DYNAMIC) == 0 || <f64>first.stillFor < t.sleepTime) continue;
    fallAsleep(t, row);
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
    sleeperOf(t, islandOf(t, row)).stillFor = <real>Infinity;
  }
}

function fallAsleep(t: RigidTable, row: i32): void {
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
  sleeper.fx = get(t.forceX, row);
  sleeper.fy = get(t.forceY, row);
  sleeper.torque = torqueOn(t, row);
}

// @ts-ignore: decorator
@inline function torqueOn(t: RigidTable, row: i32): real {
  return t.torqueZ == 0 ? <real>0 : get(t.torqueZ, row);
}

// A sleeping body on which other forces act than when it fell asleep wakes in the next step.
function watchSleepers(t: RigidTable): void {
  for (let row = 1; row < t.rows; row++) {
    const flags = flagsOf(t, row);
    if ((flags & (ASLEEP | PART)) != ASLEEP) continue;
    const pose = poseOf(t, row);
    const sleeper = sleeperOf(t, row);
    const x = get(t.forceX, row) - sleeper.fx;
    const y = get(t.forceY, row) - sleeper.fy;
    const turn = abs<real>(torqueOn(t, row) - sleeper.torque) * pose.inverseInertia * pose.extent;
    const acceleration = sqrt<real>(x * x + y * y) * pose.inverseMass + turn;
    if (acceleration > WAKING_ACCELERATION) putFlags(t, row, flags | WAKES);
  }
}

// Whether a sleeping body was moved, or left, since it fell asleep.
// @ts-ignore: decorator
@inline export function wasDisturbed(t: RigidTable, row: i32): bool {
  const c = columns();
  const pose = poseOf(t, row);
  if (get(c.positionX, row) != pose.x || get(c.positionY, row) != pose.y) return true;
  if (get(t.angle, row) != sleeperOf(t, row).angle) return true;
  if ((flagsOf(t, row) & COLLIDES) != 0 && hasNewCollider(t, row)) return true;
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
