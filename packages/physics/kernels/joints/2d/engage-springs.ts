// Springs of joints in trees. Each is a direction that gives way, solved together with all locked ones of its tree. By itself it would
// know the masses of its two bodies and not what hangs on them, nor what other springs do to these in the same sub-step: fast ones in
// series would gain energy from that. With the impulse λ, the speed u along the direction that all joints leave, and of softness.ts the
// part D of its speed that it keeps and its bias rate β,
//
//   u + g λ + β x = 0                g = D k/(1 - D)          k: inverse mass of both bodies, 1/kg
//
// which is what a spring by itself exerts, too (softImpulse). A soft pass moves bodies by a part q of what it finds, so that there
// λ = q y and the speed u* = u_0 + (u - u_0)/q:      u* + g y = -β x/q - u_0 (1/q - 1)
import { get } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { DISTANCE, JointTable, impulsesOf, isSolvedApart, lockAddress } from './joint-table';
import { isInTree } from './joint-trees';
import { APART, JointRow, JointWork, MOST_LOCKS, SPRING_ROW, hasOwnDirection, rowOf } from './joint-work';
import { addLock, coupling, removeLock, speedAlong, stateA, stateB } from './joint-rows';
import { couplingOnRails } from './row-locks';
import { softenJoint } from './soft-impulse';
import { softenInTree } from './spring-softness';

// Whether the spring of a joint is solved with its tree unless its limits or its motor are.
// @ts-ignore: decorator
@inline function hasTreeSpring(t: JointTable, work: JointWork): bool {
  if (work.hasAxes == 0 || work.kind == DISTANCE || isSolvedApart(work.kind) || !isInTree(work.parent)) return false;
  return get(t.hertz, work.id) > 0;
}

// Whether it always is: nothing but the spring acts in its direction. Before joints are measured, any motor does.
export function isSpringAlone(t: JointTable, work: JointWork): bool {
  if (!hasTreeSpring(t, work) || word(t.hasLimits, work.id) != 0) return false;
  return !(get(t.maxMotor, work.id) > 0) || hasOwnDirection(work);
}

// After limits and motors: where none of them acts in its direction, a spring gives way in it.
export function engageSpring(t: JointTable, rigid: RigidTable, work: JointWork): void {
  work.springLock = -1;
  if (!hasTreeSpring(t, work) || work.limit != 0 || work.locks >= MOST_LOCKS) return;
  // A motor that pushes may come to hold its speed in this sub-step, and then needs the row.
  if (work.motor != APART && !hasOwnDirection(work)) return;
  const row = rowOf(work, SPRING_ROW);
  const k = inverseMassAlong(work, row);
  if (!(k > 0)) return;
  softenInTree(t, work, k, rigid.h);
  work.give = (softness.impulseScale * k) / softness.massScale;
  work.springBias = softness.biasRate * row.error;
  softenJoint(rigid);
  const speed = speedAlong(stateA(rigid, work), stateB(rigid, work), row);
  const part = 1 / softness.massScale;
  work.springLock = addLock(work, row, 0, part * work.springBias + (part - 1) * speed);
  work.springPush = 0;
}

// The inverse mass of both bodies along the axis of a slider or a suspension, as far as its own locked directions let them move: a slider
// does not turn b, however far from its centre it holds it.
function inverseMassAlong(work: JointWork, row: JointRow): f64 {
  const k = coupling(work, row, row);
  const turns = row.x == 0 && row.y == 0;
  if (turns || work.ownLocks == 0) return k;
  const across = rowOf(work, 0);
  const angle = rowOf(work, 1);
  const p = couplingOnRails(work, row, across);
  const kp = couplingOnRails(work, across, across);
  const ifItTurns = kp > 0 ? k - (p * p) / kp : k;
  if (work.ownLocks == 1) return ifItTurns;
  const q = couplingOnRails(work, row, angle);
  const kq = couplingOnRails(work, angle, angle);
  const pq = couplingOnRails(work, across, angle);
  const both = kp * kq - pq * pq;
  return both > SINGULAR * kp * kq ? k - (kq * p * p - 2 * pq * p * q + kp * q * q) / both : ifItTurns;
}

// Less of a determinant is rounding.
const SINGULAR: f64 = 1e-12;

// Before what joints pulled is taken back: the spring goes on from what it has exerted.
export function relaxSpring(t: JointTable, work: JointWork): void {
  if (work.springLock < 0) return;
  const exerted = load<f64>(lockAddress(impulsesOf(t, work.id), work.springLock));
  rowOf(work, work.springLock).chord = work.springBias + work.give * exerted;
}

// Ends a sub-step: what the spring has exerted.
export function settleSpring(t: JointTable, work: JointWork): void {
  if (work.springLock < 0) return;
  const impulses = impulsesOf(t, work.id);
  impulses.spring = load<f64>(lockAddress(impulses, work.springLock));
  removeLock(work, impulses, work.springLock);
  work.springLock = -1;
}
