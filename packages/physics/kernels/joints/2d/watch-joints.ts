// Forces and torques of joints, and which joints break by them.
import { get } from '../../memory/columns';
import { putWord } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { GEAR, JointImpulses, JointTable, MOTOR, PULLEY, impulsesOf } from './joint-table';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, isHinge, rowOf, workAt } from './joint-work';

// Sums over the rows of a joint: the impulse, N s, and the angular impulse, N m s, on b.
let sumX: f64 = 0;
let sumY: f64 = 0;
let sumTurn: f64 = 0;

// Ends a sub-step: keeps the largest impulse and angular impulse.
// @ts-ignore: decorator
@inline export function watchJoint(t: JointTable, work: JointWork): void {
  if (isHinge(work)) {
    sumX = work.impulseX;
    sumY = work.impulseY;
    sumTurn = 0;
  }
  if (!isHinge(work) || work.hasAxes != 0) sumImpulses(work, impulsesOf(t, work.id));
  work.largest = max<f64>(work.largest, sumX * sumX + sumY * sumY);
  work.largestTurn = max<f64>(work.largestTurn, abs<f64>(sumTurn));
}

function sumImpulses(work: JointWork, impulses: JointImpulses): void {
  if (!isHinge(work)) sumLocks(work, impulses);
  // Of pulleys and gears one row belongs to b.
  if (work.kind == PULLEY) addImpulse(rowOf(work, SPRING_ROW), impulses.upper);
  if (work.kind == GEAR) addImpulse(rowOf(work, SPRING_ROW), impulses.lock0);
  if (work.hasAxes == 0 || work.kind >= MOTOR) return;
  addImpulse(rowOf(work, SPRING_ROW), impulses.spring + impulses.lower - impulses.upper);
  addImpulse(rowOf(work, MOTOR_ROW), impulses.motor);
}

function sumLocks(work: JointWork, impulses: JointImpulses): void {
  sumX = 0;
  sumY = 0;
  sumTurn = 0;
  const locks = work.kind == MOTOR ? 3 : work.locks;
  for (let p = 0; p < locks; p++)
    addImpulse(rowOf(work, p), load<f64>(changetype<usize>(impulses) + ((<usize>p) << 3)));
}

// A row without a direction turns bodies, and another pushes them.
function addImpulse(row: JointRow, impulse: f64): void {
  sumX += impulse * row.x;
  sumY += impulse * row.y;
  if (row.x == 0 && row.y == 0) sumTurn += impulse * row.armB;
}

// Ends a step: keeps what hinges exerted for the next step, the largest forces and torques, and lists the joints that were
// loaded beyond what they bear.
export function listBroken(table: usize): void {
  const t = changetype<JointTable>(table);
  const h = changetype<RigidTable>(t.rigid).h;
  t.brokenCount = 0;
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    const id = work.id;
    const impulses = impulsesOf(t, id);
    if (isHinge(work)) {
      impulses.lock0 = work.impulseX;
      impulses.lock1 = work.impulseY;
    }
    impulses.force = sqrt<f64>(work.largest) / h;
    impulses.torque = work.largestTurn / h;
    const isTorn = exceeds(impulses.force, <f64>get(t.breakForce, id));
    if (isTorn || exceeds(impulses.torque, <f64>get(t.breakTorque, id))) putWord(t.broken, t.brokenCount++, id);
  }
}

// @ts-ignore: decorator
@inline function exceeds(load: f64, limit: f64): bool {
  return limit > 0 && load > limit;
}
