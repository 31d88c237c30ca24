// Fills the blocks of contacts for the sub-steps of a step, and empties them into the contacts afterwards.
import { LANES } from '../../memory/lanes';
import { get, put } from '../../memory/columns';
import {
  ContactPoint,
  FORESEEN,
  RigidContact,
  contactAt,
  pointOf,
} from '../../collision/narrow-phase/2d/rigid-contact';
import { roundingOf } from '../../collision/shapes/2d/shape-pool';
import { BodyPose, LOCKED, MOVES, WALL, flagsOf, poseOf, putWord, stateOf, word } from './body';
import { layOutBlocks, takeLane } from './color-contacts';
import * as block from './contact-block';
import { noteDepth } from './crowds';
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

export function prepareContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  t.deepCount = 0;
  t.hitCount = 0;
  const hertz = min<f64>(t.contactHertz, MAX_PART_OF_RATE / t.h);
  soften(hertz, t.contactDampingRatio, t.h);
  const biasRate = <real>(softness.biasRate * softness.massScale);
  const massScale = <real>softness.massScale;
  const impulseScale = <real>softness.impulseScale;
  // Against what does not move contacts are stiffer, so that nothing is pushed through the ground, and against what is much
  // heavier, so that it does not sink into what bears it.
  soften(2 * hertz, t.contactDampingRatio, t.h);
  for (let i = 0; i < t.touchingCount; i++) {
    const slot = word(t.touching, 2 * i);
    const lane = takeLane(t, word(t.touching, 2 * i + 1));
    const at = block.blockOf(t, lane / LANES);
    const l = lane & (LANES - 1);
    if (l == 0) clearBlock(t, at);
    const contact = contactAt(t, slot);
    putWord(at + block.SLOT, l, slot);
    const single = isUneven(poseOf(t, contact.bodyA).inverseMass, poseOf(t, contact.bodyB).inverseMass);
    put(at + block.BIAS_RATE, l, single ? <real>(softness.biasRate * softness.massScale) : biasRate);
    put(at + block.MASS_SCALE, l, single ? <real>softness.massScale : massScale);
    put(at + block.IMPULSE_SCALE, l, single ? <real>softness.impulseScale : impulseScale);
    fillBodies(t, contact, at, l);
    for (let p = 0; p < contact.count; p++) fillPoint(t, contact, at, l, p);
    noteDepth(t, contact);
  }
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
  memory.fill(at, 0, block.CONTACT_BLOCK);
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
  const a = poseOf(t, contact.bodyA);
  const b = poseOf(t, contact.bodyB);
  putWord(at + block.A, l, <i32>changetype<usize>(stateOf(t, solverRow(t, contact.bodyA))));
  putWord(at + block.B, l, <i32>changetype<usize>(stateOf(t, solverRow(t, contact.bodyB))));
  put(at + block.MASS_AX, l, inverseMassX(t, contact.bodyA));
  put(at + block.MASS_AY, l, inverseMassY(t, contact.bodyA));
  put(at + block.INERTIA_A, l, a.inverseInertia);
  put(at + block.MASS_BX, l, inverseMassX(t, contact.bodyB));
  put(at + block.MASS_BY, l, inverseMassY(t, contact.bodyB));
  put(at + block.INERTIA_B, l, b.inverseInertia);
  put(at + block.NX, l, contact.nx);
  put(at + block.NY, l, contact.ny);
  put(at + block.FRICTION, l, contact.friction);
  put(at + block.TANGENT_SPEED, l, contact.tangentSpeed);
  put(at + block.ROLLING, l, contact.rollingResistance);
  const turning = a.inverseInertia + b.inverseInertia;
  put(at + block.ROLLING_MASS, l, turning > 0 ? <real>1 / turning : <real>0);
  put(at + block.ROLLING_IMPULSE, l, contact.rollingImpulse);
  put(at + block.RESTITUTION, l, contact.restitution);
  put(at + block.ROUNDING_A, l, roundingAt(t, contact.a));
  put(at + block.ROUNDING_B, l, roundingAt(t, contact.b));
}

// @ts-ignore: decorator
@inline function fillAnchors(point: ContactPoint, half: real, at: usize, l: i32, to: usize): void {
  const nx = get(at + block.NX, l);
  const ny = get(at + block.NY, l);
  const roundingA = half + get(at + block.ROUNDING_A, l);
  const roundingB = half + get(at + block.ROUNDING_B, l);
  const ax = point.ax - roundingA * nx;
  const ay = point.ay - roundingA * ny;
  const bx = point.bx + roundingB * nx;
  const by = point.by + roundingB * ny;
  put(to + block.AX, l, ax);
  put(to + block.AY, l, ay);
  put(to + block.BX, l, bx);
  put(to + block.BY, l, by);
  put(to + block.SEPARATION, l, point.separation - (nx * (bx - ax) + ny * (by - ay)));
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

// @ts-ignore: decorator
@inline function fillPoint(t: RigidTable, contact: RigidContact, at: usize, l: i32, p: i32): void {
  const point = pointOf(contact, p);
  const to = at + block.POINTS + <usize>p * block.POINT;
  const nx = contact.nx;
  const ny = contact.ny;
  // Points are half-way between the surfaces. What the bodies exert on each other acts where these meet, or angular momentum would
  // not be conserved. The points of a predicted contact are there already.
  const half = (contact.flags & FORESEEN) != 0 ? <real>0 : <real>0.5 * max<real>(0, point.separation);
  const ax = point.ax - half * nx;
  const ay = point.ay - half * ny;
  const bx = point.bx + half * nx;
  const by = point.by + half * ny;
  fillAnchors(point, half, at, l, to);
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
  const normalA = ax * ny - ay * nx;
  const normalB = bx * ny - by * nx;
  // The tangent is the normal turned to the right: (ny, -nx).
  const tangentA = ax * nx + ay * ny;
  const tangentB = bx * nx + by * ny;
  const normal = normalMass + a.inverseInertia * normalA * normalA + b.inverseInertia * normalB * normalB;
  const tangent = tangentMass + a.inverseInertia * tangentA * tangentA + b.inverseInertia * tangentB * tangentB;
  put(to + block.NORMAL_MASS, l, normal > 0 ? <real>1 / normal : <real>0);
  put(to + block.TANGENT_MASS, l, tangent > 0 ? <real>1 / tangent : <real>0);
  put(to + block.NORMAL_IMPULSE, l, point.normalImpulse);
  put(to + block.TANGENT_IMPULSE, l, point.tangentImpulse);
  const sa = stateOf(t, solverRow(t, contact.bodyA));
  const sb = stateOf(t, solverRow(t, contact.bodyB));
  const vx = sb.vx - sb.w * by - (sa.vx - sa.w * ay);
  const vy = sb.vy + sb.w * bx - (sa.vy + sa.w * ax);
  point.normalSpeed = nx * vx + ny * vy;
  put(to + block.NORMAL_SPEED, l, point.normalSpeed);
  if (p == 1 && point.normalSpeed < -block.HIT_SPEED) t.hitCount++;
}

// Keeps the impulses for the next step, and for who asks about this one.
export function storeImpulses(table: usize): void {
  const t = changetype<RigidTable>(table);
  layOutBlocks(t);
  for (let i = 0; i < t.touchingCount; i++) {
    const lane = takeLane(t, word(t.touching, 2 * i + 1));
    storeContact(contactAt(t, word(t.touching, 2 * i)), block.blockOf(t, lane / LANES), lane & (LANES - 1));
  }
}

// @ts-ignore: decorator
@inline function storeContact(contact: RigidContact, at: usize, l: i32): void {
  contact.rollingImpulse = get(at + block.ROLLING_IMPULSE, l);
  for (let p = 0; p < contact.count; p++) {
    const point = pointOf(contact, p);
    const from = at + block.POINTS + <usize>p * block.POINT;
    point.normalImpulse = get(from + block.NORMAL_IMPULSE, l);
    point.tangentImpulse = get(from + block.TANGENT_IMPULSE, l);
    point.totalImpulse = get(from + block.TOTAL_IMPULSE, l);
  }
}
