// Motors of joints in trees. One that can hold its speed locks its direction, and is solved together with all others of its tree;
// one that cannot pushes with all its force. By itself it would know the masses of its two bodies and not what hangs on them, and
// would tear at the hinge that it turns. As for limits (engage-limits.ts) one exchange is made in each sub-step, which begins with
// what was true in the one before.
import { get } from '../../memory/columns';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { DISTANCE, JointImpulses, JointTable, impulsesOf, isSolvedApart, lockAddress } from './joint-table';
import { BOTH } from './engage-limits';
import { LOOP } from './joint-trees';
import { relaxSpring } from './engage-springs';
import { addLock, applyAlong, coupling, removeLock, speedAlong, stateA, stateB } from './joint-rows';
import { APART, JointWork, MOST_LOCKS, MOTOR_ROW, hasOwnDirection, rowOf, workAt } from './joint-work';
import { endPush } from './push-axes';
import { couplingOnRails } from './row-locks';

// What the motor of a joint does in this sub-step besides nothing, APART: it holds its speed; it pushes with all its force.
const HOLDS: i32 = 1;
const PUSHES_UP: i32 = 2;
const PUSHES_DOWN: i32 = 3;
// A brake at a limit goes on with what it exerted: it changes nothing there, and no joint trembles.
const RESTS: i32 = 4;

// Begins a sub-step of a joint, before its motor has done anything. While a limit bears its direction is locked, and the motor pushes
// into the limit (`press`), or is solved by itself; but a wheel turns about an axis that has no limits.
export function startMotor(t: JointTable, rigid: RigidTable, work: JointWork): void {
  work.motor = APART;
  work.motorLock = -1;
  work.push = 0;
  if (work.hasAxes == 0 || isSolvedApart(work.kind)) return;
  const impulses = impulsesOf(t, work.id);
  const isFree = hasOwnDirection(work);
  if (!isFree) cancelPress(impulses);
  const isRigid = work.locks >= MOST_LOCKS || (work.kind == DISTANCE && work.locks > 0);
  if (work.parent == LOOP || isRigid || !(get(t.maxMotor, work.id) > 0)) return;
  if (isFree || (impulses.lower == 0 && impulses.upper == 0)) work.motor = HOLDS;
  else work.motor = atLimit(impulses, <f64>get(t.motorSpeed, work.id));
}

// What a motor presses into its limit and what that answers act on the same two bodies along the same direction: only their sum moves
// anything. So only that is kept for the next sub-step. The motor may be reversed in it, or the limit may be elsewhere, and one would be
// without the other.
function cancelPress(impulses: JointImpulses): void {
  const pressed = impulses.motor;
  const answer = pressed > 0 ? impulses.upper : impulses.lower;
  const both = min<f64>(abs<f64>(pressed), answer);
  if (!(both > 0)) return;
  // It goes on to bear, though nothing is left to be answered.
  const rest = max<f64>(answer - both, LEAST);
  if (pressed > 0) {
    impulses.motor = pressed - both;
    impulses.upper = rest;
  } else {
    impulses.motor = pressed + both;
    impulses.lower = rest;
  }
}

// A limit bears as long as it exerts more than nothing, N s.
const LEAST: f64 = 1e-300;

// Beside what it has to hold, a motor pushes into its limit with no more than what gives its two bodies this speed in a sub-step, m/s or
// rad/s. Nothing moves by it, and a load that grows by less finds the limit where it was. A limit gives way by some of it (COMPLIANCE).
const MOST_PRESS: f64 = 100;

// @ts-ignore: decorator
@inline function atLimit(impulses: JointImpulses, speed: f64): i32 {
  if (speed == 0) return RESTS;
  const ahead = speed < 0 ? impulses.lower : impulses.upper;
  const behind = speed < 0 ? impulses.upper : impulses.lower;
  return ahead > 0 && behind <= 0 ? HOLDS : APART;
}

// The largest impulse of a motor in a sub-step.
// @ts-ignore: decorator
@inline function mostOf(t: JointTable, rigid: RigidTable, work: JointWork): f64 {
  return <f64>get(t.maxMotor, work.id) * rigid.h;
}

// The speed along the row of a motor with which the joint moves at that of the motor.
// @ts-ignore: decorator
@inline export function speedFor(t: JointTable, work: JointWork): f64 {
  return <f64>get(t.motorSpeed, work.id) - rowOf(work, MOTOR_ROW).chord;
}

// How much faster the joint is than its motor wants it to be.
// @ts-ignore: decorator
@inline function excessOf(t: JointTable, rigid: RigidTable, work: JointWork): f64 {
  const speed = speedAlong(stateA(rigid, work), stateB(rigid, work), rowOf(work, MOTOR_ROW));
  return speed - speedFor(t, work);
}

// Decides what a motor does. One that gave all it had goes on to do so as long as its speed is not reached; and one that could not
// bring its two bodies to its speed, by themselves, cannot do so with what hangs on them. It pushes the other way at once when its speed
// changes sign: holding one sub-step long a speed that it cannot reach would move the bodies by it.
export function predictMotor(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (work.motor != HOLDS) return;
  const row = rowOf(work, MOTOR_ROW);
  const before = impulsesOf(t, work.id).motor;
  const most = mostOf(t, rigid, work);
  const excess = excessOf(t, rigid, work);
  const isSpent = abs<f64>(before) >= most && before * excess < SLOW * most;
  const wanted = before - excess / coupling(work, row, row);
  if (isSpent) work.motor = before > 0 ? PUSHES_UP : PUSHES_DOWN;
  else if (abs<f64>(wanted) > most && (abs<f64>(before) < most || wanted * before < 0))
    work.motor = excess < 0 ? PUSHES_UP : PUSHES_DOWN;
}

// One that is faster than it should be by less than this, m/s or rad/s, goes on to push, and holds at the end of the sub-step if it still
// is (`exchangeMotors`): brakes in a heap, which contacts hold as well, would take turns with these for ever.
const SLOW: f64 = 0.05;

// Takes back what it exerted in the last sub-step.
export function takeBackMotor(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (work.motor == APART) return;
  const row = rowOf(work, MOTOR_ROW);
  applyAlong(work, stateA(rigid, work), stateB(rigid, work), row, -impulsesOf(t, work.id).motor);
}

// After the limits: locks its direction, or pushes.
export function engageMotor(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  work.push = 0;
  if (work.motor == APART) return;
  if (work.motor == HOLDS && !isLimited(work)) return lockMotor(t, work, softSpeed(t, rigid, work));
  const impulses = impulsesOf(t, work.id);
  let most = mostOf(t, rigid, work);
  if (isLimited(work)) {
    const row = rowOf(work, MOTOR_ROW);
    most = min<f64>(most, abs<f64>(impulses.motor) + MOST_PRESS / coupling(work, row, row));
    press(work, <f64>get(t.motorSpeed, work.id));
  }
  if (work.motor == HOLDS || work.motor == RESTS) impulses.motor = max<f64>(-most, min<f64>(most, impulses.motor));
  else impulses.motor = work.motor == PUSHES_UP ? most : -most;
  work.push = impulses.motor / softness.massScale;
}

// A motor whose speed leads into the limit that bears pushes into it, and what it presses there does not come back by itself.
function press(work: JointWork, speed: f64): void {
  if (work.limit == BOTH || !(speed * work.limit < 0)) return;
  work.motor = speed > 0 ? PUSHES_UP : PUSHES_DOWN;
  work.returns = 0;
}

// Whether a limit has locked the direction in which the motor acts.
// @ts-ignore: decorator
@inline function isLimited(work: JointWork): bool {
  return work.limit != 0 && !hasOwnDirection(work);
}

function lockMotor(t: JointTable, work: JointWork, speed: f64): void {
  work.motorLock = addLock(work, rowOf(work, MOTOR_ROW), 0, -speed);
  if (work.motorLock >= 0) impulsesOf(t, work.id).motor = 0;
}

// The speed to solve for in a soft pass so that the joint then has that of its motor. A locked direction gives way under a load until
// its error pushes back; a motor has no error, and would go on to give way. So it is to be as much faster as what the joint exerted in
// the last sub-step makes it give way (soft-impulse.ts): under a load that stays, that is all. To make its direction more rigid instead
// would leave what is held from several sides, such as a bridge by the friction of its hinges, without a solution.
// @ts-ignore: decorator
@inline function softSpeed(t: JointTable, rigid: RigidTable, work: JointWork): f64 {
  const scale = softness.massScale;
  return speedFor(t, work) + (giveOf(t, work) - (1 - scale) * excessOf(t, rigid, work)) / scale;
}

// How fast the direction of a motor gives way under what its joint exerted in the last sub-step.
function giveOf(t: JointTable, work: JointWork): f64 {
  const impulses = impulsesOf(t, work.id);
  const row = rowOf(work, MOTOR_ROW);
  let give = couplingOnRails(work, row, row) * impulses.motor;
  for (let lock = 0; lock < work.ownLocks; lock++) {
    give += couplingOnRails(work, row, rowOf(work, lock)) * load<f64>(lockAddress(impulses, lock));
  }
  return softness.compliance * give;
}

// Before what joints pulled is taken back: motors that would have to exert more than they can push with all they have, and those
// that pushed too far hold. Returns whether there are any.
export function exchangeMotors(t: JointTable, rigid: RigidTable): bool {
  let any = false;
  for (let k = 0; k < t.closedCount; k++) {
    const work = workAt(t, k);
    const pushed = softness.massScale * work.push;
    endPush(work);
    relaxSpring(t, work);
    if (work.motor != APART && (work.motorLock >= 0 ? overload(t, rigid, work) : overtake(t, rigid, work, pushed)))
      any = true;
  }
  return any;
}

function overload(t: JointTable, rigid: RigidTable, work: JointWork): bool {
  const impulses = impulsesOf(t, work.id);
  const held = load<f64>(lockAddress(impulses, work.motorLock));
  const most = mostOf(t, rigid, work);
  if (abs<f64>(held) <= most) {
    rowOf(work, work.motorLock).chord = -speedFor(t, work);
    return false;
  }
  unlockMotor(t, work);
  impulses.motor = held > 0 ? most : -most;
  work.push = impulses.motor - held;
  return true;
}

function overtake(t: JointTable, rigid: RigidTable, work: JointWork, pushed: f64): bool {
  const impulses = impulsesOf(t, work.id);
  if (isLimited(work) || !(impulses.motor * excessOf(t, rigid, work) > 0)) return false;
  lockMotor(t, work, speedFor(t, work));
  if (work.motorLock < 0) return false;
  work.push = 0;
  store<f64>(lockAddress(impulses, work.motorLock), pushed);
  return true;
}

function unlockMotor(t: JointTable, work: JointWork): void {
  removeLock(work, impulsesOf(t, work.id), work.motorLock);
  work.motorLock = -1;
}

// Ends a sub-step: what a motor that held its speed has exerted.
export function settleMotor(t: JointTable, work: JointWork): void {
  work.push = 0;
  work.springPush = 0;
  // Joints may be relaxed once more, after impacts, in which motors have no part.
  work.motor = APART;
  if (work.motorLock < 0) return;
  const impulses = impulsesOf(t, work.id);
  impulses.motor = load<f64>(lockAddress(impulses, work.motorLock));
  unlockMotor(t, work);
}
