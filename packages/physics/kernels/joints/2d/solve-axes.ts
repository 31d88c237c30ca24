// Solves the rows along the free direction of a joint: spring, motor and limits, one row each.
//
//   spring   a damped spring of frequency f and damping ratio ζ about its rest (softness.ts)
//   motor    Δλ = -m (u - speed), |λ| at most the largest force times h
//   limits   Δλ = -m (u + s/h) where the limit is s away, else soft as a locked direction; λ >= 0
//
// Those of joints in trees are solved with the locked directions of these (engage-limits.ts, engage-motors.ts, engage-springs.ts):
// here are the others.
//
// Source: Box2D 3 (revolute_joint.c, prismatic_joint.c).
import { get } from '../../memory/columns';
import { BodyState, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { DISTANCE, JointImpulses, JointTable, MOTOR, impulsesOf, isCoupling, isSolvedApart } from './joint-table';
import { speedFor } from './engage-motors';
import { isSpringAlone } from './engage-springs';
import { CLOSING, LOOP } from './joint-trees';
import { APART, JointWork, MOTOR_ROW, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, coupling, finite, speedAlong, stateA, stateB } from './joint-rows';
import { limitImpulse, softImpulse, softenJoint } from './soft-impulse';
import { solveCoupling } from './solve-couplings';
import { softenAlone } from './spring-softness';
import { solveMotorJoint } from './solve-motor-joint';

export function solveAxes(table: usize, soft: i32): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.axisCount; i++) {
    const work = workAt(t, word(t.axes, i));
    const a = stateA(rigid, work);
    const b = stateB(rigid, work);
    const impulses = impulsesOf(t, work.id);
    if (work.kind == MOTOR) solveMotorJoint(t, work, impulses, rigid);
    if (isCoupling(work.kind) && work.parent != CLOSING) solveCoupling(t, work, impulses, soft != 0);
    if (isSolvedApart(work.kind)) continue;
    if (get(t.hertz, work.id) > 0 && work.springLock < 0 && !(soft != 0 && isSpringAlone(t, work)))
      solveSpring(t, work, a, b, impulses, rigid.h);
    if (get(t.maxMotor, work.id) > 0 && work.motor == APART) solveMotor(t, work, a, b, impulses, rigid.h);
    if (word(t.hasLimits, work.id) != 0 && work.parent == LOOP) solveLimits(t, work, a, b, impulses, soft != 0);
  }
}

function solveSpring(t: JointTable, work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, h: f64): void {
  const id = work.id;
  const row = rowOf(work, SPRING_ROW);
  const rest = work.kind == DISTANCE ? <f64>get(t.length, id) : 0;
  const k = coupling(work, row, row);
  softenAlone(t, work, k, h);
  const stretch = row.error - rest;
  const bias = softness.biasRate * stretch;
  const wanted = softImpulse(k, speedAlong(a, b, row) + bias, to.spring);
  const impulse = work.kind == DISTANCE ? withinForces(t, work, stretch, wanted, to.spring, h) : wanted;
  to.spring += impulse;
  applyAlong(work, a, b, row, impulse);
}

// Keeps what a spring exerts in a step below its largest forces. A slack cord exerts none: its damping would pull what flies apart.
function withinForces(t: JointTable, work: JointWork, stretch: f64, impulse: f64, before: f64, h: f64): f64 {
  const most = <f64>get(t.maxForce, work.id) * h;
  const push = min<f64>(most, <f64>get(t.maxCompression, work.id) * h);
  const pull = push == 0 && stretch < 0 ? 0 : most;
  if (before + impulse > push) return push - before;
  return before + impulse < -pull ? -pull - before : impulse;
}

function solveMotor(t: JointTable, work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, h: f64): void {
  const row = rowOf(work, MOTOR_ROW);
  const k = coupling(work, row, row);
  if (!(k > 0)) return;
  const most = <f64>get(t.maxMotor, work.id) * h;
  const wanted = to.motor - (speedAlong(a, b, row) - speedFor(t, work)) / k;
  const impulse = finite(min<f64>(most, max<f64>(-most, wanted)) - to.motor);
  to.motor += impulse;
  applyAlong(work, a, b, row, impulse);
}

function solveLimits(t: JointTable, work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, soft: bool): void {
  const rigid = changetype<RigidTable>(t.rigid);
  const row = rowOf(work, SPRING_ROW);
  softenJoint(rigid);
  const k = coupling(work, row, row);
  const low = row.error - <f64>get(t.lower, work.id);
  const up = limitImpulse(k, speedAlong(a, b, row) + row.chord, low, to.lower, rigid.h, soft);
  to.lower += up;
  applyAlong(work, a, b, row, up);
  const high = <f64>get(t.upper, work.id) - row.error;
  const down = limitImpulse(k, -speedAlong(a, b, row) - row.chord, high, to.upper, rigid.h, soft);
  to.upper += down;
  applyAlong(work, a, b, row, -down);
}
