// The rows of a joint where its bodies are now.
import { get } from '../../memory/columns';
import { cosine, sine } from '../../math/elementary';
import { BodyPose, BodyState, poseOf, stateOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { DISTANCE, GEAR, JointTable, MOTOR, PRISMATIC, PULLEY, REVOLUTE, WELD, WHEEL } from './joint-table';
import { addStiffness } from './brace-joints';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, rowOf } from './joint-work';
import { measureGear, measurePulley } from './solve-couplings';

// Closer points have no direction between them.
const MIN_DISTANCE: f64 = 1e-9;

// Of the joint that is measured: anchors from the centres, the vector between them, and angle of b from a.
let rax: f64 = 0;
let ray: f64 = 0;
let rbx: f64 = 0;
let rby: f64 = 0;
let dx: f64 = 0;
let dy: f64 = 0;
let turn: f64 = 0;
let ca: f64 = 1;
let sa: f64 = 0;

export function measureJoint(t: JointTable, work: JointWork): void {
  locate(t, work);
  const id = work.id;
  const kind = work.kind;
  if (kind == REVOLUTE || kind == WELD) lockPoint(work);
  // A weld with a spring bends.
  if (kind == WELD && get(t.hertz, id) == 0) lockAngle(work, 2);
  if (work.hasAxes != 0) aboutAngle(rowOf(work, SPRING_ROW), turn);
  if (work.hasAxes != 0) aboutAngle(rowOf(work, MOTOR_ROW), turn);
  if (kind == PRISMATIC || kind == WHEEL) alongAxis(t, work, kind == PRISMATIC);
  if (kind == DISTANCE) alongLine(t, work);
  if (kind == MOTOR) followPoint(work);
  if (kind == PULLEY) measurePulley(t, work, rax, ray, rbx, rby);
  if (kind == GEAR) measureGear(t, work);
  if (work.locks > 0) addStiffness(t, work, rax, ray, rbx, rby);
}

function locate(t: JointTable, work: JointWork): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const id = work.id;
  const a = poseOf(rigid, work.rowA);
  const b = poseOf(rigid, work.rowB);
  const stateA = stateOf(rigid, work.a);
  const stateB = stateOf(rigid, work.b);
  turnTo(a, stateA);
  ca = cosineNow;
  sa = sineNow;
  rax = ca * <f64>get(t.ax, id) - sa * <f64>get(t.ay, id);
  ray = sa * <f64>get(t.ax, id) + ca * <f64>get(t.ay, id);
  turnTo(b, stateB);
  rbx = cosineNow * <f64>get(t.bx, id) - sineNow * <f64>get(t.by, id);
  rby = sineNow * <f64>get(t.bx, id) + cosineNow * <f64>get(t.by, id);
  dx = <f64>b.x - <f64>a.x + (<f64>stateB.dx - <f64>stateA.dx) + rbx - rax;
  dy = <f64>b.y - <f64>a.y + (<f64>stateB.dy - <f64>stateA.dy) + rby - ray;
  const start = <f64>get(rigid.angle, work.rowB) - <f64>get(rigid.angle, work.rowA);
  turn = start + (<f64>stateB.turned - <f64>stateA.turned) - <f64>get(t.angle, id);
}

let cosineNow: f64 = 1;
let sineNow: f64 = 0;

// Cosine and sine of the angle of a body now.
// @ts-ignore: decorator
@inline function turnTo(pose: BodyPose, state: BodyState): void {
  cosineNow = <f64>pose.c * <f64>state.dc - <f64>pose.s * <f64>state.ds;
  sineNow = <f64>pose.s * <f64>state.dc + <f64>pose.c * <f64>state.ds;
}

// @ts-ignore: decorator
@inline function setRow(row: JointRow, x: f64, y: f64, armA: f64, armB: f64, error: f64): void {
  row.x = x;
  row.y = y;
  row.armA = armA;
  row.armB = armB;
  row.error = error;
}

function lockPoint(work: JointWork): void {
  setRow(rowOf(work, 0), 1, 0, -ray, -rby, dx);
  setRow(rowOf(work, 1), 0, 1, rax, rbx, dy);
  work.locks = 2;
}

function lockAngle(work: JointWork, i: i32): void {
  aboutAngle(rowOf(work, i), turn);
  work.locks = i + 1;
}

// A motor joint pulls at the point and the angle, and locks neither.
function followPoint(work: JointWork): void {
  lockPoint(work);
  aboutAngle(rowOf(work, 2), turn);
  work.locks = 0;
}

// @ts-ignore: decorator
@inline function aboutAngle(row: JointRow, angle: f64): void {
  setRow(row, 0, 0, 1, 1, angle);
}

// The axis is fixed to a. Nothing moves across it; b moves along it.
function alongAxis(t: JointTable, work: JointWork, keepsAngle: bool): void {
  const angle = <f64>get(t.axis, work.id);
  const c = cosine(angle);
  const s = sine(angle);
  const ux = ca * c - sa * s;
  const uy = sa * c + ca * s;
  const px = rax + dx;
  const py = ray + dy;
  setRow(rowOf(work, 0), -uy, ux, px * ux + py * uy, rbx * ux + rby * uy, dy * ux - dx * uy);
  work.locks = 1;
  setRow(rowOf(work, SPRING_ROW), ux, uy, px * uy - py * ux, rbx * uy - rby * ux, dx * ux + dy * uy);
  if (!keepsAngle) return;
  lockAngle(work, 1);
  const along = rowOf(work, SPRING_ROW);
  setRow(rowOf(work, MOTOR_ROW), ux, uy, along.armA, along.armB, along.error);
}

// Without spring and limits the distance is locked.
function alongLine(t: JointTable, work: JointWork): void {
  const id = work.id;
  const distance = sqrt<f64>(dx * dx + dy * dy);
  const near = distance < MIN_DISTANCE;
  const ux = near ? 1 : dx / distance;
  const uy = near ? 0 : dy / distance;
  const armA = rax * uy - ray * ux;
  const armB = rbx * uy - rby * ux;
  setRow(rowOf(work, SPRING_ROW), ux, uy, armA, armB, distance);
  setRow(rowOf(work, MOTOR_ROW), ux, uy, armA, armB, distance);
  work.locks = 0;
  if (get(t.hertz, id) > 0 || word(t.hasLimits, id) != 0) return;
  setRow(rowOf(work, 0), ux, uy, armA, armB, distance - <f64>get(t.length, id));
  work.locks = 1;
}
