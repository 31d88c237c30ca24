// Islands whose kinetic energy is bounded.
//
// Crowds: bodies that were put into each other, or into what does not move. Each contact pushes its two bodies apart at a bounded
// speed, but the pushes of many layers add up, and one relaxing pass cannot take back what they gave, nor what two walls gave to
// what is wedged between them. So in a sub-step of a crowd
//
//   before positions change   no body is faster than overlap is pushed out, nor than the fastest before contacts were solved
//   when all is relaxed       the kinetic energy is at most what it was before: contacts give none
//
// Loops of joints between bodies of unlike masses: a joint that closes a loop begins a sub-step with what it exerted in the last
// one (solve-loops.ts), which may be far off where a light body swings a heavy one. Of both, at the end of a step
//
//   when all has bounced      the kinetic energy is at most that of the start and what forces gave since
//
// Speeds are about the centre of mass, or about what no contact moves if the island touches that: the ground, or a lift. They are
// scaled all alike, which conserves momentum, keeps what rests at rest, and brings nothing closer together that parts. Islands that
// something drives, a motor, a spring, a belt, or kinematic bodies that turn or move against the ground, may gain energy and stay as
// they are.
import {
  ContactPoint,
  IS_DEEP,
  RigidContact,
  WAS_TOUCHING,
  contactAt,
  pointOf,
} from '../../collision/narrow-phase/2d/rigid-contact';
import { DRIVEN, DYNAMIC, KINEMATIC, LOCKED, LOOPED, flagsOf, poseOf, putWord, stateOf, word } from './body';
import { noteDeepPair } from './deep-pairs';
import { islandOf, labelIslands } from './islands';
import { RigidTable } from './rigid-table';

// A contact is deep if two bodies overlap by half the lesser of their least extents from the centre when it begins, and did not
// come so far by their speed: they were put there. It stays deep until they overlap by a twentieth.
const DEEP: real = 0.5;
const FLAT: real = 0.05;

// Minimum number of deep contacts of a crowd, and maximum number of its bodies for each: in larger heaps pushes are absorbed.
const FEWEST: i32 = 2;
const BODIES: i32 = 50;

// Masses of a loop are unlike from this ratio on.
export const UNLIKE: f64 = 10;

// Contacts push a little faster than they are set to. What is taken of that, relaxing takes once more from what the bodies did before: a
// body alone, which may be on its way through a chain from behind, keeps its speed. A factor of the square.
const PUSHED: f64 = 1.1;

// What is known of an island, in the record of its first row. Speeds and energies are about its frame.
@unmanaged
export class Crowd {
  // Velocity of the frame, m/s: that of the centre of mass, or of what the island touches that no contact moves.
  vx: f64;
  vy: f64;
  anchorX: f64;
  anchorY: f64;
  mass: f64;
  // Kinetic energy, J, and the square of the largest speed: before contacts are solved, and now.
  energyBefore: f64;
  fastestBefore: f64;
  energy: f64;
  fastest: f64;
  // Kinetic energy of the start of the step and what forces gave since, J.
  given: f64;
  // The masses of the lightest and of the heaviest body, kg.
  lightest: f64;
  heaviest: f64;
  bodies: i32;
  deepContacts: i32;
  // Ends of joints that close loops.
  loopEnds: i32;
  // Whether it touches what no contact moves, and whether something drives it.
  anchored: i32;
  driven: i32;
}

const SIZE: usize = (offsetof<Crowd>() + 7) & ~7;

// @ts-ignore: decorator
@inline function crowdOf(t: RigidTable, row: i32): Crowd {
  return changetype<Crowd>(t.crowds + <usize>row * SIZE);
}

// Finds whether a contact that touches is deep.
// @ts-ignore: decorator
@inline export function noteDepth(t: RigidTable, contact: RigidContact): void {
  if ((contact.flags & (WAS_TOUCHING | IS_DEEP)) == WAS_TOUCHING) return;
  if (isDeep(t, contact)) {
    contact.flags |= IS_DEEP;
    t.deepCount += weightOf(t, contact);
    noteDeepPair(t, contact);
  } else contact.flags &= ~IS_DEEP;
}

// What is put into something that does not move may be held by it from two sides, and counts as much as two bodies in one.
// @ts-ignore: decorator
@inline function weightOf(t: RigidTable, contact: RigidContact): i32 {
  return poseOf(t, contact.bodyA).inverseMass == 0 || poseOf(t, contact.bodyB).inverseMass == 0 ? FEWEST : 1;
}

function isDeep(t: RigidTable, contact: RigidContact): bool {
  const a = poseOf(t, contact.bodyA);
  const b = poseOf(t, contact.bodyB);
  // What has no thickness, as the ground of a chain, is overlapped by any contact.
  const thinner = min<real>(a.minExtent, b.minExtent);
  const extent = thinner > 0 ? thinner : max<real>(a.minExtent, b.minExtent);
  const point = deepest(contact);
  if ((contact.flags & IS_DEEP) != 0) return -point.separation > FLAT * extent;
  // Twice the way of a step, because contacts may have slowed the bodies since.
  return -point.separation > max<real>(DEEP * extent, -2 * normalSpeed(t, contact, point) * <real>t.dt);
}

// The speed of b from a along the normal, m/s.
function normalSpeed(t: RigidTable, contact: RigidContact, point: ContactPoint): real {
  const a = stateOf(t, contact.bodyA);
  const b = stateOf(t, contact.bodyB);
  const x = b.vx - b.w * point.by - (a.vx - a.w * point.ay);
  const y = b.vy + b.w * point.bx - (a.vy + a.w * point.ax);
  return contact.nx * x + contact.ny * y;
}

// @ts-ignore: decorator
@inline function deepest(contact: RigidContact): ContactPoint {
  const point = pointOf(contact, 0);
  if (contact.count < 2) return point;
  const other = pointOf(contact, 1);
  return other.separation < point.separation ? other : point;
}

// Lists the bodies of all crowds, and returns their number.
export function findCrowds(table: usize): i32 {
  const t = changetype<RigidTable>(table);
  t.crowdedCount = 0;
  if (t.deepCount < FEWEST && t.loopCount == 0) return 0;
  labelIslands(table);
  for (let i = 0; i < t.awakeCount; i++) memory.fill(changetype<usize>(crowdOf(t, word(t.awake, i))), 0, SIZE);
  for (let i = 0; i < t.touchingCount; i++) noteContact(t, contactAt(t, word(t.touching, 2 * i)));
  for (let i = 0; i < t.linkCount; i++) notePair(t, word(t.links, 2 * i), word(t.links, 2 * i + 1));
  for (let i = 0; i < t.awakeCount; i++) noteBody(t, word(t.awake, i));
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    if ((flagsOf(t, row) & DYNAMIC) != 0 && isCrowd(crowdOf(t, islandOf(t, row))))
      putWord(t.crowded, t.crowdedCount++, row);
  }
  return t.crowdedCount;
}

// @ts-ignore: decorator
@inline function isCrowd(crowd: Crowd): bool {
  return crowd.driven == 0 && (isDeepCrowd(crowd) || (crowd.loopEnds > 0 && crowd.heaviest > UNLIKE * crowd.lightest));
}

// @ts-ignore: decorator
@inline function isDeepCrowd(crowd: Crowd): bool {
  return crowd.deepContacts >= max<i32>(FEWEST, crowd.bodies / BODIES);
}

function noteBody(t: RigidTable, row: i32): void {
  const flags = flagsOf(t, row);
  if ((flags & DYNAMIC) == 0) return;
  const crowd = crowdOf(t, islandOf(t, row));
  const mass = 1 / <f64>poseOf(t, row).inverseMass;
  crowd.lightest = crowd.bodies == 0 ? mass : min<f64>(crowd.lightest, mass);
  crowd.heaviest = max<f64>(crowd.heaviest, mass);
  crowd.bodies++;
  if ((flags & LOOPED) != 0) crowd.loopEnds++;
  if ((flags & DRIVEN) != 0) crowd.driven = 1;
  if ((flags & LOCKED) != 0) anchor(crowd, 0, 0);
}

function noteContact(t: RigidTable, contact: RigidContact): void {
  const crowd = notePair(t, contact.bodyA, contact.bodyB);
  if (contact.tangentSpeed != 0) crowd.driven = 1;
  if ((contact.flags & IS_DEEP) != 0) crowd.deepContacts += weightOf(t, contact);
}

// Two bodies that touch or are joined, one of which may be row 0.
function notePair(t: RigidTable, a: i32, b: i32): Crowd {
  const kindA = flagsOf(t, a);
  const kindB = flagsOf(t, b);
  const crowd = crowdOf(t, islandOf(t, (kindA & DYNAMIC) != 0 ? a : b));
  if ((kindA & kindB & DYNAMIC) == 0) anchorTo(t, crowd, (kindA & DYNAMIC) != 0 ? b : a);
  return crowd;
}

function anchorTo(t: RigidTable, crowd: Crowd, row: i32): void {
  if ((flagsOf(t, row) & KINEMATIC) == 0) return anchor(crowd, 0, 0);
  const state = stateOf(t, row);
  if (state.w != 0) crowd.driven = 1;
  anchor(crowd, <f64>state.vx, <f64>state.vy);
}

// Two anchors of unlike velocities drive what is between them.
function anchor(crowd: Crowd, vx: f64, vy: f64): void {
  if (crowd.anchored != 0 && (vx != crowd.anchorX || vy != crowd.anchorY)) crowd.driven = 1;
  crowd.anchored = 1;
  crowd.anchorX = vx;
  crowd.anchorY = vy;
}

// Before contacts are solved: the frame, the energy and the largest speed of each crowd.
export function measureCrowds(table: usize): void {
  const t = changetype<RigidTable>(table);
  findFrames(t);
  for (let i = 0; i < t.crowdedCount; i++) {
    const crowd = crowdOf(t, word(t.crowded, i));
    crowd.given -= isDeepCrowd(crowd) ? min<f64>(crowd.energy, crowd.energyBefore) : crowd.energy;
  }
  measure(t);
  for (let i = 0; i < t.crowdedCount; i++) {
    const crowd = crowdOf(t, word(t.crowded, i));
    crowd.given += crowd.energy;
    crowd.energyBefore = crowd.energy;
    crowd.fastestBefore = crowd.fastest;
  }
}

function findFrames(t: RigidTable): void {
  for (let i = 0; i < t.crowdedCount; i++) {
    const crowd = crowdOf(t, word(t.crowded, i));
    crowd.mass = 0;
    crowd.vx = crowd.anchorX;
    crowd.vy = crowd.anchorY;
  }
  for (let i = 0; i < t.crowdedCount; i++) {
    const row = word(t.crowded, i);
    const crowd = crowdOf(t, islandOf(t, row));
    if (crowd.anchored != 0) continue;
    const state = stateOf(t, row);
    const mass = 1 / <f64>poseOf(t, row).inverseMass;
    crowd.mass += mass;
    // The mean so far, and what this body adds to it.
    crowd.vx += (mass / crowd.mass) * (<f64>state.vx - crowd.vx);
    crowd.vy += (mass / crowd.mass) * (<f64>state.vy - crowd.vy);
  }
}

function measure(t: RigidTable): void {
  for (let i = 0; i < t.crowdedCount; i++) {
    const crowd = crowdOf(t, word(t.crowded, i));
    crowd.energy = 0;
    crowd.fastest = 0;
  }
  for (let i = 0; i < t.crowdedCount; i++) {
    const row = word(t.crowded, i);
    const crowd = crowdOf(t, islandOf(t, row));
    const state = stateOf(t, row);
    const pose = poseOf(t, row);
    const x = <f64>state.vx - crowd.vx;
    const y = <f64>state.vy - crowd.vy;
    const w = <f64>state.w;
    const speed2 = x * x + y * y;
    crowd.fastest = max<f64>(crowd.fastest, speed2);
    crowd.energy += (0.5 * speed2) / <f64>pose.inverseMass;
    if (pose.inverseInertia > 0) crowd.energy += (0.5 * w * w) / <f64>pose.inverseInertia;
  }
}

// Before positions change: bounds the speeds.
export function limitCrowdSpeeds(table: usize): void {
  const t = changetype<RigidTable>(table);
  const pushed = t.contactSpeed * t.contactSpeed;
  measure(t);
  for (let i = 0; i < t.crowdedCount; i++) {
    const row = word(t.crowded, i);
    const crowd = crowdOf(t, islandOf(t, row));
    const bound = max<f64>(crowd.fastestBefore, crowd.bodies == 1 ? PUSHED * pushed : pushed);
    if (isDeepCrowd(crowd) && crowd.fastest > bound) scale(t, row, crowd, sqrt<f64>(bound / crowd.fastest));
  }
}

// When all is relaxed: bounds the energy.
export function limitCrowdEnergies(table: usize): void {
  const t = changetype<RigidTable>(table);
  measure(t);
  for (let i = 0; i < t.crowdedCount; i++) {
    const row = word(t.crowded, i);
    const crowd = crowdOf(t, islandOf(t, row));
    if (isDeepCrowd(crowd)) boundEnergy(t, row, crowd, crowd.energyBefore);
  }
}

// Ends the step, when all has bounced: bounds the energy.
export function endCrowds(table: usize): void {
  const t = changetype<RigidTable>(table);
  measure(t);
  for (let i = 0; i < t.crowdedCount; i++) {
    const row = word(t.crowded, i);
    const crowd = crowdOf(t, islandOf(t, row));
    boundEnergy(t, row, crowd, max<f64>(0, crowd.given));
  }
}

// @ts-ignore: decorator
@inline function boundEnergy(t: RigidTable, row: i32, crowd: Crowd, bound: f64): void {
  if (crowd.energy > bound) scale(t, row, crowd, sqrt<f64>(bound / crowd.energy));
}

function scale(t: RigidTable, row: i32, crowd: Crowd, factor: f64): void {
  const state = stateOf(t, row);
  state.vx = <real>(crowd.vx + factor * (<f64>state.vx - crowd.vx));
  state.vy = <real>(crowd.vy + factor * (<f64>state.vy - crowd.vy));
  state.w = <real>(factor * <f64>state.w);
}
