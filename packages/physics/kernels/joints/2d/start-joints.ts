// Begins a sub-step of the joints: their directions now, the inertias that they see, and the impulses of the last sub-step.
import { poseOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { articulated, startBody } from './articulated-body';
import { braced } from './brace-joints';
import { applyAtHinge } from './hinge-locks';
import { GEAR, JointTable, MOTOR, PULLEY, impulsesOf } from './joint-table';
import { JointWork, MOTOR_ROW, SPRING_ROW, childOf, isHinge, rowOf, workAt } from './joint-work';
import { applyAlong, applyLocks, stateA, stateB } from './joint-rows';
import { measureJoint } from './measure-joints';
import { warmStartCoupling } from './solve-couplings';
import { warmStartMotorJoint } from './solve-motor-joint';

export function startJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let k = 0; k < t.workCount; k++) measureJoint(t, workAt(t, k));
  for (let k = 0; k < t.rootCount; k++) startRoot(t, rigid, word(t.roots, k));
  for (let k = 0; k < t.workCount; k++) {
    const work = workAt(t, k);
    work.inertiaA = inertiaOf(t, rigid, work.a, work.rowA);
    work.inertiaB = inertiaOf(t, rigid, work.b, work.rowB);
    startChild(t, work);
    warmStart(t, rigid, work);
  }
}

// @ts-ignore: decorator
@inline function inertiaOf(t: JointTable, rigid: RigidTable, node: i32, row: i32): f64 {
  return braced(<f64>poseOf(rigid, row).inverseInertia, rigid.h * articulated(t, node).stiffness);
}

function startRoot(t: JointTable, rigid: RigidTable, row: i32): void {
  startBody(t, row, <f64>poseOf(rigid, row).inverseMass, inertiaOf(t, rigid, row, row));
}

// Every other body of a tree is the child of one joint.
// @ts-ignore: decorator
@inline function startChild(t: JointTable, work: JointWork): void {
  const child = childOf(work);
  if (child == 0) return;
  if (work.parent == 1) startBody(t, child, work.massB, work.inertiaB);
  else startBody(t, child, work.massA, work.inertiaA);
}

function warmStart(t: JointTable, rigid: RigidTable, work: JointWork): void {
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  if (isHinge(work)) applyAtHinge(work, a, b, work.impulseX, work.impulseY);
  if (isHinge(work) && work.hasAxes == 0) return;
  const impulses = impulsesOf(t, work.id);
  if (!isHinge(work) && work.locks > 0) applyLocks(work, a, b, impulses.lock0, impulses.lock1, impulses.lock2);
  if (work.hasAxes == 0) return;
  if (work.kind == MOTOR) return warmStartMotorJoint(work, a, b, impulses);
  if (work.kind == PULLEY || work.kind == GEAR) return warmStartCoupling(work, a, b, impulses);
  applyAlong(work, a, b, rowOf(work, SPRING_ROW), impulses.spring + impulses.lower - impulses.upper);
  applyAlong(work, a, b, rowOf(work, MOTOR_ROW), impulses.motor);
}
