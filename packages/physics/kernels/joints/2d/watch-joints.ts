// Forces and torques of joints, and which joints break by them.
import { get } from '../../memory/columns';
import { LANES } from '../../memory/lanes';
import { putWord, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { stiffenByRod } from './brace-rods';
import { keepVelocity, stiffen } from './brace-joints';
import * as block from './loop-block';
import { blockOf } from './loop-block';
import {
  DISTANCE,
  GEAR,
  JointImpulses,
  JointTable,
  MOTOR,
  PULLEY,
  impulsesOf,
  isSolvedApart,
  lockAddress,
} from './joint-table';
import { JointRow, JointWork, MOTOR_ROW, PLAIN, SPRING_ROW, placeAt, rowOf, signOf, workAt } from './joint-work';

// Sums over the rows of a joint: the impulse, N s, and the angular impulse, N m s, on b.
let sumX: f64 = 0;
let sumY: f64 = 0;
let sumTurn: f64 = 0;

// Ends a sub-step of a joint that is no hinge, or has axes: keeps the largest impulse and angular impulse.
export function watchJoint(t: JointTable, k: i32): void {
  const work = workAt(t, k);
  const at = placeAt(t, k);
  const impulses = impulsesOf(t, work.id);
  if (at.hinge != 0) {
    sumX = at.impulseX * signOf(at);
    sumY = at.impulseY * signOf(at);
    sumTurn = 0;
  } else {
    sumLocks(work, impulses);
  }
  sumAxes(work, impulses);
  keepVelocity(t, changetype<RigidTable>(t.rigid), work.a);
  keepVelocity(t, changetype<RigidTable>(t.rigid), work.b);
  at.largest = max<f64>(at.largest, sumX * sumX + sumY * sumY);
  work.largestTurn = max<f64>(work.largestTurn, abs<f64>(sumTurn));
}

// What the locked directions do to the bodies when these turn (brace-joints.ts).
export function stiffenByLocks(t: JointTable, work: JointWork, impulses: JointImpulses): void {
  if (work.kind == DISTANCE) return stiffenByRod(t, work);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const x = impulses.lock0 * r0.x + impulses.lock1 * r1.x + impulses.lock2 * r2.x;
  const y = impulses.lock0 * r0.y + impulses.lock1 * r1.y + impulses.lock2 * r2.y;
  stiffen(t, work.a, x, y, -work.rax, -work.ray);
  stiffen(t, work.b, x, y, work.rbx, work.rby);
}

function sumAxes(work: JointWork, impulses: JointImpulses): void {
  // Of pulleys and gears one row belongs to b.
  if (work.kind == PULLEY) addImpulse(rowOf(work, SPRING_ROW), impulses.upper);
  if (work.kind == GEAR) addImpulse(rowOf(work, SPRING_ROW), impulses.lock0);
  if (work.hasAxes == 0 || isSolvedApart(work.kind)) return;
  addImpulse(rowOf(work, SPRING_ROW), impulses.spring + impulses.lower - impulses.upper);
  addImpulse(rowOf(work, MOTOR_ROW), impulses.motor);
}

function sumLocks(work: JointWork, impulses: JointImpulses): void {
  sumX = 0;
  sumY = 0;
  sumTurn = 0;
  const locks = work.kind == MOTOR ? 3 : work.locks;
  for (let p = 0; p < locks; p++) addImpulse(rowOf(work, p), load<f64>(lockAddress(impulses, p)));
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
  const rate = 1 / changetype<RigidTable>(t.rigid).h;
  t.brokenCount = 0;
  for (let i = 0; i < t.workCount; i++) {
    const at = placeAt(t, i);
    const impulses = impulsesOf(t, at.id);
    if (at.hinge != 0) {
      impulses.lock0 = at.impulseX * signOf(at);
      impulses.lock1 = at.impulseY * signOf(at);
    }
    const torque = at.hinge == PLAIN ? 0 : workAt(t, i).largestTurn * rate;
    note(t, at.id, impulses, sqrt<f64>(at.largest) * rate, torque);
  }
  for (let i = 0; i < t.blockCount; i++) noteBlock(t, blockOf(t, i), rate);
}

function noteBlock(t: JointTable, at: usize, rate: f64): void {
  for (let l = 0; l < LANES; l++) {
    const id = word(at + block.JOINT, l);
    if (id < 0) continue;
    const impulses = impulsesOf(t, id);
    impulses.lock0 = <f64>get(at + block.IMPULSE_X, l);
    impulses.lock1 = <f64>get(at + block.IMPULSE_Y, l);
    note(t, id, impulses, sqrt<f64>(<f64>get(at + block.LARGEST, l)) * rate, 0);
  }
}

// @ts-ignore: decorator
@inline function note(t: JointTable, id: i32, impulses: JointImpulses, force: f64, torque: f64): void {
  impulses.force = force;
  impulses.torque = torque;
  const isTorn = exceeds(force, <f64>get(t.breakForce, id)) || exceeds(torque, <f64>get(t.breakTorque, id));
  if (isTorn) putWord(t.broken, t.brokenCount++, id);
}

// @ts-ignore: decorator
@inline function exceeds(load: f64, limit: f64): bool {
  return limit > 0 && load > limit;
}
