// Joints that couple motions of two bodies in different directions. Their coordinate q has a row for each body:
//
//   pulley   q = L - l_a - ratio · l_b                  q >= 0: the rope pulls, and may be slack
//   gear     q = θ_b - ratio · θ_a - q_0                q = 0; of a rack the way of b along an axis stands for θ_b
//
// l is the length of rope between a body and its wheel. Sources: Box2D 2.4 (b2_pulley_joint.cpp, b2_gear_joint.cpp), whose
// pulley is a rod that also pushes.
import { get } from '../../memory/columns';
import { cosine, sine } from '../../math/elementary';
import { BodyState, poseOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { JointedBody, jointed } from './brace-joints';
import { bend, chordOfLength, withinSpeed } from './chords';
import { JointImpulses, JointTable, PULLEY, impulsesOf } from './joint-table';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, rowOf } from './joint-work';
import { bounded, stateA, stateB } from './joint-rows';
import { limitImpulse, softImpulse, softenJoint } from './soft-impulse';

// The rows of the two bodies, in places that these joints do not use otherwise; the arm of each is that of its body.
export const ROW_A: i32 = MOTOR_ROW;
export const ROW_B: i32 = SPRING_ROW;

// The least length even without a load.
const MIN_ROPE: f64 = 1e-9;

export function measurePulley(t: JointTable, work: JointWork): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const id = work.id;
  const a = poseOf(rigid, work.rowA);
  const b = poseOf(rigid, work.rowB);
  const rax = work.rax;
  const ray = work.ray;
  const rbx = work.rbx;
  const rby = work.rby;
  const ratio = <f64>get(t.ratio, id);
  const ax = <f64>a.x + <f64>stateA(rigid, work).dx + rax - <f64>get(t.pulleyAx, id);
  const ay = <f64>a.y + <f64>stateA(rigid, work).dy + ray - <f64>get(t.pulleyAy, id);
  const bx = <f64>b.x + <f64>stateB(rigid, work).dx + rbx - <f64>get(t.pulleyBx, id);
  const by = <f64>b.y + <f64>stateB(rigid, work).dy + rby - <f64>get(t.pulleyBy, id);
  const pull = pullOfLate(impulsesOf(t, id));
  const most = AT_WHEEL * longest(t, id);
  const leastA = min<f64>(most, leastRope(rigid.h, pull, <f64>a.inverseMass, 1));
  const leastB = min<f64>(most, leastRope(rigid.h, pull, <f64>b.inverseMass, ratio));
  const ropeA = shorten(rowOf(work, ROW_A), ax, ay, rax, ray, 1, leastA);
  const ropeB = shorten(rowOf(work, ROW_B), bx, by, rbx, rby, ratio, leastB);
  const chordA = chordOfRope(rowOf(work, ROW_A), jointed(t, work.a), rax, ray, ropeA, 1, leastA);
  const chordB = chordOfRope(rowOf(work, ROW_B), jointed(t, work.b), rbx, rby, ropeB, ratio, leastB);
  const speedA = speedOfRope(rowOf(work, ROW_A), jointed(t, work.a));
  const speedB = speedOfRope(rowOf(work, ROW_B), jointed(t, work.b));
  rowOf(work, ROW_B).chord = withinSpeed(chordA + chordB, speedA + speedB);
  rowOf(work, ROW_B).error = <f64>get(t.length, id) - ropeA - ratio * ropeB;
}

// A rope with the force F, from one sub-step to the next, swings a mass m with the frequency √(F/(l m)), which sub-steps can follow
// down to this length. What is drawn up to its wheel comes to rest there: nearer to it the rope pulls by less, in proportion to its
// length. Else it would throw its body from side to side, and give way each time.
// @ts-ignore: decorator
@inline function leastRope(h: f64, pull: f64, inverseMass: f64, ratio: f64): f64 {
  return max<f64>(MIN_ROPE, FOLLOWED * h * ratio * pull * inverseMass);
}

// How much a rope of a mechanism gives way, as a part of the inverse mass of its bodies. What is wound too far against something that is
// held, which hardly gives way either, would be pulled without bound, and swing faster than sub-steps can follow: a rope gives way in
// proportion to its pull, in units of that at which they can follow these bodies at a rope as long as this. A load of a thousand times
// the mass of its bodies moves it by some millimetres.
export function giveOfRope(t: JointTable, rigid: RigidTable, work: JointWork): f64 {
  const pull = pullOfLate(impulsesOf(t, work.id));
  const part = leastRope(rigid.h, pull, inverseMassOf(work), 1) / longest(t, work.id);
  return GIVE * min<f64>(1 / GIVE, part);
}

const GIVE: f64 = 0.04;

// @ts-ignore: decorator
@inline function longest(t: JointTable, id: i32): f64 {
  return max<f64>(MIN_ROPE, <f64>get(t.length, id));
}

// The greatest pull of late: a rope that jerks pulls in some sub-steps only.
// @ts-ignore: decorator
@inline function pullOfLate(impulses: JointImpulses): f64 {
  return max<f64>(impulses.upper, impulses.lock1);
}

// Begins a sub-step.
export function notePullOfRope(impulses: JointImpulses): void {
  impulses.lock1 = KEPT * pullOfLate(impulses);
}

// How much of the greatest pull is left after a sub-step.
const KEPT: f64 = 0.81;

// The least length, in units of h² F/m.
const FOLLOWED: f64 = 2;

// A body is near its wheel within this part of the rope at most. Farther away a weaker row would only need a harder pull, and that a
// weaker row.
const AT_WHEEL: f64 = 0.5;

// The row along which a rope gets shorter, `ratio` times. Returns the length of the rope.
function shorten(row: JointRow, x: f64, y: f64, rx: f64, ry: f64, ratio: f64, least: f64): f64 {
  const length = sqrt<f64>(x * x + y * y);
  const k = -ratio / max<f64>(length, least);
  row.x = k * x;
  row.y = k * y;
  row.armA = rx * row.y - ry * row.x;
  row.armB = row.armA;
  return length;
}

// How fast a rope got shorter at the end of the last sub-step.
function speedOfRope(row: JointRow, body: JointedBody): f64 {
  return row.x * body.vx + row.y * body.vy + row.armA * body.w;
}

// The chord (chords.ts) of a rope that gets shorter along a row, `ratio` times; its body is held at (rx, ry) from its centre.
function chordOfRope(row: JointRow, body: JointedBody, rx: f64, ry: f64, length: f64, ratio: f64, least: f64): f64 {
  if (!(length > least) || ratio == 0) return 0;
  const across = (row.x * (body.vy + body.w * rx) - row.y * (body.vx - body.w * ry)) / ratio;
  const turning = bend(body.w, body.halfStep) * (row.x * rx + row.y * ry);
  return -ratio * chordOfLength(length, across, body.halfStep) - turning;
}

export function measureGear(t: JointTable, work: JointWork): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const id = work.id;
  const ratio = <f64>get(t.ratio, id);
  const rowA = rowOf(work, ROW_A);
  rowA.x = 0;
  rowA.y = 0;
  rowA.armA = -ratio;
  const angleA = <f64>get(rigid.angle, work.rowA) + <f64>stateA(rigid, work).turned;
  const q = motionOfB(t, rigid, work) - ratio * angleA - <f64>get(t.angle, id);
  rowOf(work, ROW_B).error = q;
}

// The row of b, and how far b has turned or gone along the axis.
function motionOfB(t: JointTable, rigid: RigidTable, work: JointWork): f64 {
  const row = rowOf(work, ROW_B);
  const b = stateB(rigid, work);
  row.x = 0;
  row.y = 0;
  row.armB = 1;
  if (word(t.isRack, work.id) == 0) return <f64>get(rigid.angle, work.rowB) + <f64>b.turned;
  const angle = <f64>get(t.axis, work.id);
  row.x = cosine(angle);
  row.y = sine(angle);
  row.armB = 0;
  const pose = poseOf(rigid, work.rowB);
  return row.x * (<f64>pose.x + <f64>b.dx) + row.y * (<f64>pose.y + <f64>b.dy);
}

export function warmStartCoupling(work: JointWork, a: BodyState, b: BodyState, impulses: JointImpulses): void {
  exertCoupling(work, a, b, work.kind == PULLEY ? impulses.upper : impulses.lock0);
}

export function solveCoupling(t: JointTable, work: JointWork, impulses: JointImpulses, soft: bool): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const gap = rowOf(work, ROW_B).error;
  const k = inverseMassOf(work);
  softenJoint(rigid);
  if (work.kind == PULLEY) {
    const pull = limitImpulse(
      k,
      speedOfCoupling(work, a, b) + rowOf(work, ROW_B).chord,
      gap,
      impulses.upper,
      rigid.h,
      soft,
    );
    impulses.upper += pull;
    return exertCoupling(work, a, b, pull);
  }
  if (!soft) softness.impulseScale = 0;
  if (!soft) softness.massScale = 1;
  const bias = soft ? softness.biasRate * bounded(gap) : 0;
  const turn = softImpulse(k, speedOfCoupling(work, a, b) + bias, impulses.lock0);
  impulses.lock0 += turn;
  exertCoupling(work, a, b, turn);
}

export function speedOfCoupling(work: JointWork, a: BodyState, b: BodyState): f64 {
  const p = rowOf(work, ROW_A);
  const q = rowOf(work, ROW_B);
  const ofA = p.x * <f64>a.vx + p.y * <f64>a.vy + p.armA * <f64>a.w;
  return ofA + q.x * <f64>b.vx + q.y * <f64>b.vy + q.armB * <f64>b.w;
}

export function inverseMassOf(work: JointWork): f64 {
  const p = rowOf(work, ROW_A);
  const q = rowOf(work, ROW_B);
  const ofA = work.massAx * (p.x * p.x) + work.massAy * (p.y * p.y) + work.inertiaA * p.armA * p.armA;
  return ofA + work.massBx * (q.x * q.x) + work.massBy * (q.y * q.y) + work.inertiaB * q.armB * q.armB;
}

export function exertCoupling(work: JointWork, a: BodyState, b: BodyState, impulse: f64): void {
  const p = rowOf(work, ROW_A);
  const q = rowOf(work, ROW_B);
  a.vx = <real>(<f64>a.vx + impulse * work.massAx * p.x);
  a.vy = <real>(<f64>a.vy + impulse * work.massAy * p.y);
  a.w = <real>(<f64>a.w + impulse * work.inertiaA * p.armA);
  b.vx = <real>(<f64>b.vx + impulse * work.massBx * q.x);
  b.vy = <real>(<f64>b.vy + impulse * work.massBy * q.y);
  b.w = <real>(<f64>b.w + impulse * work.inertiaB * q.armB);
}
