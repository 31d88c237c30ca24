// The anchors and rows of a joint where its bodies are now.
import { get } from '../../memory/columns';
import { cosine, sine } from '../../math/elementary';
import { BodyPose, BodyState, LOCKED, flagsOf, poseOf, stateOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { braceRod } from './brace-rods';
import { DISTANCE, GEAR, JointTable, MOTOR, PRISMATIC, PULLEY, REVOLUTE, WELD, WHEEL } from './joint-table';
import { chordOfLength, chordOfPoints, measureBends, partOfChord, withinSpeed } from './chords';
import { measureHinge } from './hinge-locks';
import { LOOP } from './joint-trees';
import { bounded, coupling, setRow } from './joint-rows';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, placeAt, rowOf, startAt, workAt } from './joint-work';
import { measureGear, measurePulley } from './solve-couplings';

// Closer points have no direction between them.
const MIN_DISTANCE: f64 = 1e-9;

export function measureJoint(t: JointTable, k: i32): void {
  const work = workAt(t, k);
  const at = placeAt(t, k);
  if (at.hinge != 0) {
    measureHinge(t, changetype<RigidTable>(t.rigid), at, startAt(t, k));
  } else {
    locate(t, work);
    measureLocks(t, work);
  }
  if (work.hasAxes != 0 && (work.kind == WELD || work.kind == REVOLUTE)) turnAbout(work, angleBetween(t, work));
}

// Cosine and sine of the angle of the body that was asked for last, now.
let cosineNow: f64 = 1;
let sineNow: f64 = 0;

// @ts-ignore: decorator
@inline function turnTo(pose: BodyPose, state: BodyState): void {
  cosineNow = <f64>pose.c * <f64>state.dc - <f64>pose.s * <f64>state.ds;
  sineNow = <f64>pose.s * <f64>state.dc + <f64>pose.c * <f64>state.ds;
}

function locate(t: JointTable, work: JointWork): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const a = poseOf(rigid, work.rowA);
  const b = poseOf(rigid, work.rowB);
  const stateA = stateOf(rigid, work.a);
  const stateB = stateOf(rigid, work.b);
  turnTo(a, stateA);
  const rax = cosineNow * work.localAx - sineNow * work.localAy;
  const ray = sineNow * work.localAx + cosineNow * work.localAy;
  turnTo(b, stateB);
  const rbx = cosineNow * work.localBx - sineNow * work.localBy;
  const rby = sineNow * work.localBx + cosineNow * work.localBy;
  work.dx = <f64>b.x - <f64>a.x + (<f64>stateB.dx - <f64>stateA.dx) + rbx - rax;
  work.dy = <f64>b.y - <f64>a.y + (<f64>stateB.dy - <f64>stateA.dy) + rby - ray;
  work.rax = rax;
  work.ray = ray;
  work.rbx = rbx;
  work.rby = rby;
  measureBends(t, work);
}

// The angle of b from a, less that of the joint, rad.
function angleBetween(t: JointTable, work: JointWork): f64 {
  const rigid = changetype<RigidTable>(t.rigid);
  const start = <f64>get(rigid.angle, work.rowB) - <f64>get(rigid.angle, work.rowA);
  const turned = <f64>stateOf(rigid, work.b).turned - <f64>stateOf(rigid, work.a).turned;
  return start + turned - <f64>get(t.angle, work.id);
}

function measureLocks(t: JointTable, work: JointWork): void {
  const kind = work.kind;
  work.locks = 0;
  work.acrossInverse = 0;
  if (kind == REVOLUTE || kind == WELD) {
    const half = work.hasAxes != 0 ? 0.5 : 0;
    lockPoint(work, half, half);
  }
  if (kind == WELD) {
    // A weld with a spring bends.
    if (get(t.hertz, work.id) == 0) lockAngle(t, work, 2);
  }
  if (kind == PRISMATIC || kind == WHEEL) alongAxis(t, work, kind == PRISMATIC);
  if (kind == DISTANCE) alongLine(t, work);
  if (kind == MOTOR) followPoint(t, work);
  if (kind == PULLEY) measurePulley(t, work);
  if (kind == GEAR) measureGear(t, work);
  work.ownLocks = work.locks;
}

function aboutAngle(row: JointRow, angle: f64): void {
  setRow(row, 0, 0, 1, 1, angle, 0);
}

// Spring, limits and motor of a hinge or a weld.
function turnAbout(work: JointWork, angle: f64): void {
  aboutAngle(rowOf(work, SPRING_ROW), angle);
  aboutAngle(rowOf(work, MOTOR_ROW), angle);
}

// Pulls at the anchors, or nearer to each other by parts of what is between them. What pulls at one point of both bodies makes no
// angular momentum: motors and limits pull for as long as they like. A hinge that only turns keeps its energy better at its anchors
// (a ring of bars of 1 : 10 loses a twentieth in half a minute else).
function lockPoint(work: JointWork, partA: f64, partB: f64): void {
  const x = chordOfPoints(work, 1, 0);
  const y = chordOfPoints(work, 0, 1);
  const part = partOfChord(x, y, work.slideX, work.slideY);
  const armAx = work.rax + partA * work.dx;
  const armAy = work.ray + partA * work.dy;
  const armBx = work.rbx - partB * work.dx;
  const armBy = work.rby - partB * work.dy;
  setRow(rowOf(work, 0), 1, 0, -armAy, -armBy, bounded(work.dx), part * x);
  setRow(rowOf(work, 1), 0, 1, armAx, armBx, bounded(work.dy), part * y);
  work.locks = 2;
}

function lockAngle(t: JointTable, work: JointWork, i: i32): void {
  aboutAngle(rowOf(work, i), bounded(angleBetween(t, work)));
  work.locks = i + 1;
}

// A motor joint pulls at the point and the angle, and locks neither. It pulls at both bodies where b is, however far that is from where
// it should be.
function followPoint(t: JointTable, work: JointWork): void {
  lockPoint(work, 1, 0);
  rowOf(work, 0).error = work.dx;
  rowOf(work, 1).error = work.dy;
  aboutAngle(rowOf(work, 2), angleBetween(t, work));
  work.locks = 0;
}

// The axis is fixed to a. Nothing moves across it; b moves along it.
function alongAxis(t: JointTable, work: JointWork, keepsAngle: bool): void {
  const rigid = changetype<RigidTable>(t.rigid);
  turnTo(poseOf(rigid, work.rowA), stateOf(rigid, work.a));
  const angle = <f64>get(t.axis, work.id);
  const c = cosine(angle);
  const s = sine(angle);
  const ux = cosineNow * c - sineNow * s;
  const uy = sineNow * c + cosineNow * s;
  const dx = work.dx;
  const dy = work.dy;
  const px = work.rax + dx;
  const py = work.ray + dy;
  const acrossB = work.rbx * ux + work.rby * uy;
  const alongB = work.rbx * uy - work.rby * ux;
  const along = dx * ux + dy * uy;
  const across = dy * ux - dx * uy;
  const slideAlong = work.slideX * ux + work.slideY * uy;
  const slideAcross = work.slideY * ux - work.slideX * uy;
  const w = work.turning;
  const turn = 2 * work.halfStep * w;
  const bentAcross = chordOfPoints(work, -uy, ux) - turn * slideAlong - work.bendA * across;
  const bentAlong = chordOfPoints(work, ux, uy) + turn * slideAcross - work.bendA * along;
  const chordAcross = withinSpeed(bentAcross, slideAcross - w * along);
  const chordAlong = withinSpeed(bentAlong, slideAlong + w * across);
  setRow(rowOf(work, 0), -uy, ux, px * ux + py * uy, acrossB, bounded(across), chordAcross);
  work.locks = 1;
  setRow(rowOf(work, SPRING_ROW), ux, uy, px * uy - py * ux, alongB, along, chordAlong);
  if (keepsAngle) {
    lockAngle(t, work, 1);
    const motorChord = withinMotorSpeed(t, work, bentAlong, slideAlong + w * across);
    setRow(rowOf(work, MOTOR_ROW), ux, uy, px * uy - py * ux, alongB, along, motorChord);
  } else if (work.hasAxes != 0) {
    // The motor of a wheel turns it.
    aboutAngle(rowOf(work, MOTOR_ROW), angleBetween(t, work));
  }
}

// What of a chord there is in a speed along it, beside that of the motor.
// @ts-ignore: decorator
@inline function withinMotorSpeed(t: JointTable, work: JointWork, chord: f64, speed: f64): f64 {
  return get(t.maxMotor, work.id) > 0 ? withinSpeed(chord, speed - <f64>get(t.motorSpeed, work.id)) : 0;
}

// Without spring and limits the distance is locked.
function alongLine(t: JointTable, work: JointWork): void {
  const id = work.id;
  const distance = sqrt<f64>(work.dx * work.dx + work.dy * work.dy);
  const near = distance < MIN_DISTANCE;
  const ux = near ? 1 : work.dx / distance;
  const uy = near ? 0 : work.dy / distance;
  const armA = work.rax * uy - work.ray * ux;
  const armB = work.rbx * uy - work.rby * ux;
  const across = work.slideY * ux - work.slideX * uy;
  const bent = chordOfPoints(work, ux, uy) + (near ? 0 : chordOfLength(distance, across, work.halfStep));
  const along = work.slideX * ux + work.slideY * uy;
  const chord = withinSpeed(bent, along);
  setRow(rowOf(work, SPRING_ROW), ux, uy, armA, armB, distance, chord);
  setRow(rowOf(work, MOTOR_ROW), ux, uy, armA, armB, distance, withinMotorSpeed(t, work, bent, along));
  work.reach = reachOf(t, work, rowOf(work, MOTOR_ROW));
  if (work.parent != LOOP) braceRod(t, work, max<f64>(distance, MIN_DISTANCE));
  if (get(t.hertz, id) > 0 || word(t.hasLimits, id) != 0) return;
  setRow(rowOf(work, 0), ux, uy, armA, armB, bounded(distance - <f64>get(t.length, id)), chord);
  work.locks = 1;
}

// Part of the inverse mass of two bodies that must be free along a rod, for it to correct its length in full.
const REACH: f64 = 0.05;

// What part of an error along a row its bodies can follow, if locks hold all that moves of them: across the axis that is left
// free a small gap would want a long way, and at last there is none.
function reachOf(t: JointTable, work: JointWork, row: JointRow): f64 {
  const rigid = changetype<RigidTable>(t.rigid);
  const a = <f64>poseOf(rigid, work.rowA).inverseMass;
  const b = <f64>poseOf(rigid, work.rowB).inverseMass;
  if (!isHeld(rigid, work.rowA, a) || !isHeld(rigid, work.rowB, b)) return 1;
  return min<f64>(1, coupling(work, row, row) / (REACH * (a + b)));
}

// @ts-ignore: decorator
@inline function isHeld(rigid: RigidTable, row: i32, inverseMass: f64): bool {
  return inverseMass == 0 || (flagsOf(rigid, row) & LOCKED) != 0;
}
