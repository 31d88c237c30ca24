// Joints begin a sub-step with the impulses of the last.
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { GEAR, JointTable, MOTOR, PULLEY, impulsesOf } from './joint-table';
import { MOTOR_ROW, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, stateA, stateB } from './joint-rows';
import { warmStartCoupling } from './solve-couplings';
import { warmStartMotorJoint } from './solve-motor-joint';

// Applies the impulses of the last sub-step once more.
export function warmStartJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    const a = stateA(rigid, work);
    const b = stateB(rigid, work);
    const impulses = impulsesOf(t, work.id);
    if (work.locks > 0) applyAlong(work, a, b, rowOf(work, 0), impulses.lock0);
    if (work.locks > 1) applyAlong(work, a, b, rowOf(work, 1), impulses.lock1);
    if (work.locks > 2) applyAlong(work, a, b, rowOf(work, 2), impulses.lock2);
  }
  for (let i = 0; i < t.axisCount; i++) {
    const work = workAt(t, word(t.axes, i));
    const a = stateA(rigid, work);
    const b = stateB(rigid, work);
    const impulses = impulsesOf(t, work.id);
    if (work.kind == MOTOR) warmStartMotorJoint(work, a, b, impulses);
    if (work.kind == PULLEY || work.kind == GEAR) warmStartCoupling(work, a, b, impulses);
    if (work.kind >= MOTOR) continue;
    applyAlong(work, a, b, rowOf(work, SPRING_ROW), impulses.spring + impulses.lower - impulses.upper);
    applyAlong(work, a, b, rowOf(work, MOTOR_ROW), impulses.motor);
  }
}
