// Fills the blocks of contacts for the sub-steps of a step, and empties them into the contacts afterwards.
import { LANES, at as laneOffset } from '../../memory/lanes';
import { clearRecord } from '../../memory/records';
import { impactDistance } from '../../collision/narrow-phase/2d/collide-ahead';
import { EDGE_OF_A, EDGE_OF_B } from '../../collision/narrow-phase/2d/manifold';
import {
  ContactPoint,
  FAST_POINT,
  FORESEEN,
  RigidContact,
  contactAt,
  pointOf,
} from '../../collision/narrow-phase/2d/rigid-contact';
import { roundingOf } from '../../collision/shapes/2d/shape-pool';
import { BodyPose, DYNAMIC, LOCKED, MOVES, ROUND, WALL, flagsOf, poseOf, putWord, stateOf, word } from './body';
import { layOutBlocks, takeLane } from './color-contacts';
import * as block from './contact-block';
import { noteDepth } from './crowds';
import { finishBlocks } from './finish-blocks';
import { inverseMassAlong, inverseMassX, inverseMassY, openAxes } from './motion-locks';
import { RigidTable } from './rigid-table';
import { soften, softness } from './softness';

// The frequency of a contact is at most this part of the rate of sub-steps.
const MAX_PART_OF_RATE: f64 = 0.125;

// A body heavier by this factor is nearly immovable for the other. Where it is heavier yet, contacts give way
// altogether: it must come through the light body, and not press that through the ground.
const MUCH_HEAVIER: real = 10;
const TOO_HEAVY: real = 2000;

// Bodies that are locked along a direction get out of each other's way by turning or by moving aside. Where that hardly helps it
// would take any speed: they yield at least by this part of what they do where it helps most.
const YIELD: real = 0.01;

// A speed is that at which a body comes to a surface in a sub-step if it is so at most, times what is left to it: room for rounding.
const REST: real = 1.01;

export function prepareContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  t.deepCount = 0;
  t.deepPairCount = 0;
  t.hitCount = 0;
  t.bouncyCount = 0;
  // Of the longest recent sub-steps: what bears a heap is as stiff in all steps, whatever lengths alternate.
  const hertz = min<f64>(t.contactHertz, MAX_PART_OF_RATE / t.recentLength);
  soften(hertz, t.contactDampingRatio, t.h);
  const biasRate = <real>(softness.biasRate * softness.massScale);
  const massScale = <real>softness.massScale;
  // Against what does not move contacts are stiffer, so that nothing is pushed through the ground, and against what is much
  // heavier, so that it does not sink into what bears it.
  soften(2 * hertz, t.contactDampingRatio, t.h);
  for (let i = 0; i < t.touchingCount; i++) {
    const slot = word(t.touching, 2 * i);
    const place = takeLane(t, word(t.touching, 2 * i + 1));
    const at = block.blockOf(t, place / LANES);
    const l = place & (LANES - 1);
    if (l == 0) clearBlock(t, at);
    const lane = at + laneOffset(l);
    const contact = contactAt(t, slot);
    putWord(at + block.SLOT, l, slot);
    const single = isUneven(poseOf(t, contact.bodyA).inverseMass, poseOf(t, contact.bodyB).inverseMass);
    store<real>(lane, single ? <real>(softness.biasRate * softness.massScale) : biasRate, block.BIAS_RATE);
    store<real>(lane, single ? <real>softness.massScale : massScale, block.MASS_SCALE);
    noteDepth(t, contact);
    fillBodies(t, contact, at, l);
    for (let p = 0; p < contact.count; p++) fillPoint(t, contact, lane, p);
    if (contact.restitution != 0) t.bouncyCount++;
  }
  finishBlocks(t);
}

// Whether one of two bodies is much heavier than the other, or does not move at all.
// @ts-ignore: decorator
@inline function isUneven(inverseMassA: real, inverseMassB: real): bool {
  const least = min<real>(inverseMassA, inverseMassB);
  const most = max<real>(inverseMassA, inverseMassB);
  return least * MUCH_HEAVIER <= most && (least == 0 || least * TOO_HEAVY >= most);
}

// Lanes without a contact act on row 0 with no mass.
// @ts-ignore: decorator
@inline function clearBlock(t: RigidTable, at: usize): void {
  clearRecord(at, block.CONTACT_BLOCK);
  const none = i32x4.splat(<i32>t.states);
  v128.store(at + block.A, none);
  v128.store(at + block.B, none);
}

// Bodies that do not move have row 0 in their place.
// @ts-ignore: decorator
@inline function solverRow(t: RigidTable, row: i32): i32 {
  return (flagsOf(t, row) & MOVES) != 0 ? row : 0;
}

// Walls are sharp.
// @ts-ignore: decorator
@inline function roundingAt(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & WALL) != 0 ? 0 : roundingOf(row);
}

// @ts-ignore: decorator
@inline function fillBodies(t: RigidTable, contact: RigidContact, at: usize, l: i32): void {
  const lane = at + laneOffset(l);
  const a = poseOf(t, contact.bodyA);
  const b = poseOf(t, contact.bodyB);
  putWord(at + block.A, l, <i32>changetype<usize>(stateOf(t, solverRow(t, contact.bodyA))));
  putWord(at + block.B, l, <i32>changetype<usize>(stateOf(t, solverRow(t, contact.bodyB))));
  store<real>(lane, inverseMassX(t, contact.bodyA), block.MASS_AX);
  store<real>(lane, inverseMassY(t, contact.bodyA), block.MASS_AY);
  store<real>(lane, a.inverseInertia, block.INERTIA_A);
  store<real>(lane, inverseMassX(t, contact.bodyB), block.MASS_BX);
  store<real>(lane, inverseMassY(t, contact.bodyB), block.MASS_BY);
  store<real>(lane, b.inverseInertia, block.INERTIA_B);
  store<real>(lane, b.x - a.x, block.APART_X);
  store<real>(lane, b.y - a.y, block.APART_Y);
  store<real>(lane, isOfStart(contact) ? <real>(0.5 * (t.dt - t.h)) : <real>0, block.AHEAD);
  store<real>(lane, contact.restitution, block.RESTITUTION);
  store<real>(lane, cornerOf(contact), block.CORNER);
  setShares(t, contact, lane);
  store<real>(lane, contact.nx, block.NX);
  store<real>(lane, contact.ny, block.NY);
  store<real>(lane, contact.friction, block.FRICTION);
  store<real>(lane, contact.tangentSpeed, block.TANGENT_SPEED);
  store<real>(lane, contact.rollingResistance, block.ROLLING);
  store<real>(lane, contact.rollingImpulse, block.ROLLING_IMPULSE);
  store<real>(lane, roundingAt(t, contact.a), block.ROUNDING_A);
  store<real>(lane, roundingAt(t, contact.b), block.ROUNDING_B);
}

// Whether the normal is that of the start of the step: those of discs are of the mean of the sub-steps, and foreseen ones of the impact.
// @ts-ignore: decorator
@inline function isOfStart(contact: RigidContact): bool {
  return (contact.flags & FORESEEN) == 0 && contact.shapeA != 0 && contact.shapeB != 0;
}

// @ts-ignore: decorator
@inline function cornerOf(contact: RigidContact): real {
  if ((contact.flags & EDGE_OF_A) != 0) return block.CORNER_OF_B;
  return (contact.flags & EDGE_OF_B) != 0 ? block.CORNER_OF_A : <real>0;
}

// Which impacts bounce is told by their speeds later, and how far levers follow by their lengths (finish-blocks.ts).
// @ts-ignore: decorator
@inline function setShares(t: RigidTable, contact: RigidContact, lane: usize): void {
  const shareA = shareOfA(t, contact);
  const follows = shareA >= 0 && (contact.flags & FORESEEN) == 0 && (contact.restitution == 0 || mayTurn(t, contact));
  store<real>(lane, follows ? shareA : <real>0, block.SHARE_A);
  store<real>(lane, follows ? <real>1 : <real>0, block.SHARES);
}

// Nothing turns smooth discs, and what is locked gets angular momentum from nowhere.
export function mayTurn(t: RigidTable, contact: RigidContact): bool {
  if (((flagsOf(t, contact.bodyA) | flagsOf(t, contact.bodyB)) & LOCKED) != 0) return false;
  return contact.shapeA != 0 || contact.shapeB != 0 || contact.friction != 0;
}

// A disc is pressed where it is round, and the lever of what is none follows alone. -1 where neither body moves.
// @ts-ignore: decorator
@inline export function shareOfA(t: RigidTable, contact: RigidContact): real {
  const inverseA = poseOf(t, contact.bodyA).inverseMass;
  const inverseB = poseOf(t, contact.bodyB).inverseMass;
  if (!(inverseA + inverseB > 0)) return -1;
  const discA = isMovingDisc(t, contact.bodyA);
  const discB = isMovingDisc(t, contact.bodyB);
  return discA == discB ? inverseB / (inverseA + inverseB) : discA ? <real>0 : <real>1;
}

// @ts-ignore: decorator
@inline function isMovingDisc(t: RigidTable, body: i32): bool {
  return (flagsOf(t, body) & (ROUND | DYNAMIC)) == (ROUND | DYNAMIC);
}

// The least inverse mass along a direction where no body is free to move along all: a part of what they have along the axes
// that are not locked, or else, by turning alone, at their extents.
function leastInverseMass(t: RigidTable, contact: RigidContact, a: BodyPose, b: BodyPose): real {
  const axesA = openAxes(t, contact.bodyA);
  const axesB = openAxes(t, contact.bodyB);
  if (axesA == 2 || axesB == 2) return 0;
  if (axesA + axesB > 0) return YIELD * ((axesA > 0 ? a.inverseMass : 0) + (axesB > 0 ? b.inverseMass : 0));
  return YIELD * (a.inverseInertia * a.extent * a.extent + b.inverseInertia * b.extent * b.extent);
}

// The arms of a point, and for the time being inverse masses without turning.
// @ts-ignore: decorator
@inline function fillPoint(t: RigidTable, contact: RigidContact, lane: usize, p: i32): void {
  const point = pointOf(contact, p);
  const to = lane + block.POINTS + <usize>p * block.POINT;
  const nx = contact.nx;
  const ny = contact.ny;
  // Points are half-way between the surfaces. What the bodies exert on each other acts where these meet, or angular momentum would
  // not be conserved. Those of a predicted contact are of the moment of the impact.
  const half =
    <real>0.5 * ((contact.flags & FORESEEN) != 0 ? impactDistance(t, contact) : max<real>(0, point.separation));
  store<real>(to, point.ax - half * nx, block.AX);
  store<real>(to, point.ay - half * ny, block.AY);
  store<real>(to, point.bx + half * nx, block.BX);
  store<real>(to, point.by + half * ny, block.BY);
  store<real>(to, point.separation, block.SEPARATION);
  store<real>(to, point.normalImpulse, block.NORMAL_IMPULSE);
  store<real>(to, point.tangentImpulse, block.TANGENT_IMPULSE);
  const a = poseOf(t, contact.bodyA);
  const b = poseOf(t, contact.bodyB);
  let normalMass = a.inverseMass + b.inverseMass;
  let tangentMass = normalMass;
  if (((flagsOf(t, contact.bodyA) | flagsOf(t, contact.bodyB)) & LOCKED) != 0) {
    normalMass = inverseMassAlong(t, contact.bodyA, nx, ny) + inverseMassAlong(t, contact.bodyB, nx, ny);
    tangentMass = inverseMassAlong(t, contact.bodyA, ny, -nx) + inverseMassAlong(t, contact.bodyB, ny, -nx);
    const least = leastInverseMass(t, contact, a, b);
    normalMass = max<real>(normalMass, least);
    tangentMass = max<real>(tangentMass, least);
  }
  store<real>(to, normalMass, block.NORMAL_MASS);
  store<real>(to, tangentMass, block.TANGENT_MASS);
}

// Keeps the impulses for the next step, and impulses and speeds for who asks about this one.
export function storeImpulses(table: usize): void {
  const t = changetype<RigidTable>(table);
  layOutBlocks(t);
  const weight = <real>t.impulseWeight;
  for (let i = 0; i < t.touchingCount; i++) {
    const place = takeLane(t, word(t.touching, 2 * i + 1));
    const lane = block.blockOf(t, place / LANES) + laneOffset(place & (LANES - 1));
    storeContact(t, contactAt(t, word(t.touching, 2 * i)), lane, weight, -(<real>t.hitSpeed));
  }
}

// @ts-ignore: decorator
@inline function storeContact(
  t: RigidTable,
  contact: RigidContact,
  lane: usize,
  weight: real,
  hitSpeed: real,
): void {
  contact.rollingImpulse = blend(contact.rollingImpulse, load<real>(lane, block.ROLLING_IMPULSE), weight);
  for (let p = 0; p < contact.count; p++) {
    const point = pointOf(contact, p);
    const from = lane + block.POINTS + <usize>p * block.POINT;
    point.normalSpeed = load<real>(from, block.NORMAL_SPEED);
    if (point.normalSpeed < hitSpeed) {
      if (isRestOfImpact(t, point)) point.normalSpeed = 0;
      else contact.flags |= FAST_POINT;
    }
    point.normalImpulse = blend(point.normalImpulse, load<real>(from, block.NORMAL_IMPULSE), weight);
    point.tangentImpulse = blend(point.tangentImpulse, load<real>(from, block.TANGENT_IMPULSE), weight);
    point.totalImpulse = load<real>(from, block.TOTAL_IMPULSE);
  }
}

// Whether the step before stopped what approaches at a point, but for the speed at which it comes to the surface in a sub-step: that
// impact is listed already.
function isRestOfImpact(t: RigidTable, point: ContactPoint): bool {
  return point.normalImpulse > 0 && -point.normalSpeed * <real>t.h <= REST * point.separation;
}

// @ts-ignore: decorator
@inline function blend(before: real, now: real, weight: real): real {
  return weight < 1 ? before + weight * (now - before) : now;
}
