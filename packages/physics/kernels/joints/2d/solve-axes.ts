// Solves the rows along the free direction of a joint: spring, motor and limits, one row each.
//
//   spring   a damped spring of frequency f and damping ratio ζ about its rest, solved implicitly (softness.ts)
//   motor    Δλ = -m (u - speed), |λ| at most the largest force times h
//   limits   Δλ = -m (u + s/h) where the limit is s away, else soft as a locked direction; λ >= 0
//
// Source: Box2D 3 (revolute_joint.c, prismatic_joint.c).
import { get } from '../../memory/columns';
import { BodyState, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { soften, softness } from '../../solver/2d/softness';
import { DISTANCE, JointImpulses, JointTable, impulsesOf } from './joint-table';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, coupling, finite, speedAlong, stateA, stateB } from './joint-rows';

// The frequency of a limit is at most this part of the rate of sub-steps, as that of a locked direction.
export const MAX_PART_OF_RATE: f64 = 0.25;

export function solveAxes(table: usize, soft: i32): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.axisCount; i++) {
    const work = workAt(t, word(t.axes, i));
    const a = stateA(rigid, work);
    const b = stateB(rigid, work);
    const impulses = impulsesOf(t, work.id);
    if (get(t.hertz, work.id) > 0) solveSpring(t, work, a, b, impulses, rigid.h);
    if (get(t.maxMotor, work.id) > 0) solveMotor(t, work, a, b, impulses, rigid.h);
    if (word(t.hasLimits, work.id) != 0) solveLimits(t, work, a, b, impulses, soft != 0);
  }
}

function solveSpring(t: JointTable, work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, h: f64): void {
  const id = work.id;
  const row = rowOf(work, SPRING_ROW);
  const rest = <u32>word(t.kind, id) == DISTANCE ? <f64>get(t.length, id) : 0;
  soften(<f64>get(t.hertz, id), <f64>get(t.dampingRatio, id), h);
  const bias = softness.biasRate * (row.error - rest);
  const impulse = softImpulse(work, row, speedAlong(a, b, row) + bias, to.spring);
  to.spring += impulse;
  applyAlong(work, a, b, row, impulse);
}

// @ts-ignore: decorator
@inline function softImpulse(work: JointWork, row: JointRow, speed: f64, before: f64): f64 {
  const k = coupling(work, row, row);
  return finite(k > 0 ? (-softness.massScale * speed) / k - softness.impulseScale * before : 0);
}

function solveMotor(t: JointTable, work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, h: f64): void {
  const row = rowOf(work, MOTOR_ROW);
  const k = coupling(work, row, row);
  if (!(k > 0)) return;
  const most = <f64>get(t.maxMotor, work.id) * h;
  const wanted = to.motor - (speedAlong(a, b, row) - <f64>get(t.motorSpeed, work.id)) / k;
  const impulse = finite(min<f64>(most, max<f64>(-most, wanted)) - to.motor);
  to.motor += impulse;
  applyAlong(work, a, b, row, impulse);
}

function solveLimits(t: JointTable, work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, soft: bool): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const row = rowOf(work, SPRING_ROW);
  soften(min<f64>(rigid.jointHertz, MAX_PART_OF_RATE / rigid.h), rigid.jointDampingRatio, rigid.h);
  const low = row.error - <f64>get(t.lower, work.id);
  const up = limitImpulse(work, row, speedAlong(a, b, row), low, to.lower, rigid.h, soft);
  to.lower += up;
  applyAlong(work, a, b, row, up);
  const high = <f64>get(t.upper, work.id) - row.error;
  const down = limitImpulse(work, row, -speedAlong(a, b, row), high, to.upper, rigid.h, soft);
  to.upper += down;
  applyAlong(work, a, b, row, -down);
}

// What must be added to the impulse of a limit that is `gap` away.
function limitImpulse(work: JointWork, row: JointRow, speed: f64, gap: f64, before: f64, h: f64, soft: bool): f64 {
  const k = coupling(work, row, row);
  if (!(k > 0)) return 0;
  let impulse = -speed / k;
  if (gap > 0) impulse = -(speed + gap / h) / k;
  else if (soft) impulse = softImpulse(work, row, speed + softness.biasRate * gap, before);
  return finite(max<f64>(before + impulse, 0) - before);
}
