// Begins a sub-step of the joints: their directions now, and the impulses of the last sub-step. A tree gets the same velocities
// whatever impulses it starts from (solve-locks.ts), so that its plain hinges begin without, and are measured when they are
// solved, where nothing looks at the velocities before that: no axis of a joint, and no body with locked axes.
import { clearRecord } from '../../memory/records';
import { LOCKED, flagsOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { ARTICULATED_BODY_SIZE, ARTICULATED_MASS_SIZE, articulated, massBeside, massOf } from './articulated-body';
import { braceTurns, startRods } from './brace-rods';
import { applyAtHinge } from './hinge-locks';
import { foreseeLimits } from './engage-limits';
import { startMotor } from './engage-motors';
import { GEAR, JointTable, MOTOR, PULLEY, impulsesOf } from './joint-table';
import { JointWork, MOTOR_ROW, PLAIN, SPRING_ROW, placeAt, rowOf, workAt } from './joint-work';
import { applyAlong, applyLocks, stateA, stateB } from './joint-rows';
import { jointsOfTree } from './list-by-tree';
import { measureJoint } from './measure-joints';
import { notePullOfRope, warmStartCoupling } from './solve-couplings';
import { softenJoint } from './soft-impulse';
import { startLoops } from './solve-loops';

export function startJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  softenJoint(rigid);
  if (t.otherCount > 0) startRods(t);
  for (let k = 0; t.otherCount > 0 && k < t.workCount; k++) {
    if (placeAt(t, k).hinge == PLAIN) continue;
    measureJoint(t, k);
    foreseeLimits(t, rigid, k);
  }
  for (let k = 0; t.otherCount > 0 && k < t.workCount; k++) {
    if (placeAt(t, k).hinge == PLAIN) continue;
    startMotor(t, rigid, workAt(t, k));
    if (workAt(t, k).kind == PULLEY) notePullOfRope(impulsesOf(t, workAt(t, k).id));
    applyImpulses(t, rigid, k, 1);
    if (workAt(t, k).hasAxes != 0) warmStartAxes(t, rigid, workAt(t, k));
  }
  clearMasses(t, rigid);
  startLoops(t);
}

// Makes the matrices of all bodies of trees ready to be added to. Those at the ends of hinges are so whenever they were read.
export function clearMasses(t: JointTable, rigid: RigidTable): void {
  memory.fill(t.masses, 0, <usize>t.rootCount * ARTICULATED_MASS_SIZE);
  for (let k = 0; t.otherCount > 0 && k < t.treeCount; k++) {
    const at = placeAt(t, k);
    if (at.hinge == 0 && at.below != 0) clearRecord(changetype<usize>(massBeside(t, at.below)), ARTICULATED_MASS_SIZE);
  }
  if (rigid.lockedCount > 0) weighLocked(t, rigid);
  if (t.otherCount > 0) braceTurns(t, rigid);
}

// Factor of a body's mass along a locked axis: large against all that is joined to it, and small enough to leave digits.
const LOCKED_MASS: f64 = 1e8;
// The same for a body with one free axis. Joints that pull across that axis fling the body along it, the faster the heavier the
// locked axis is.
export const RAIL_MASS: f64 = 1e4;

// Bodies of trees get the masses of their locked axes, to which joints add what hangs below them.
function weighLocked(t: JointTable, rigid: RigidTable): void {
  for (let i = 0; i < t.bodyCount; i++) weighBody(t, rigid, i);
}

function weighBody(t: JointTable, rigid: RigidTable, i: i32): void {
  const row = word(t.bodyRows, i);
  if ((flagsOf(rigid, row) & LOCKED) == 0) return;
  const x = word(rigid.lockX, row) != 0;
  const y = word(rigid.lockY, row) != 0;
  const locked = (x && y ? LOCKED_MASS : RAIL_MASS) * articulated(t, i).mass;
  if (x) massOf(t, i).m00 += locked;
  if (y) massOf(t, i).m11 += locked;
}

// Makes the matrices of one tree ready to be added to, in an impact (brace-rods.ts).
export function clearTree(t: JointTable, rigid: RigidTable, tree: i32): void {
  const first = word(t.treeStarts, tree);
  clearBody(t, rigid, tree);
  for (let i = 0; i < jointsOfTree(t, tree); i++) {
    const below = placeAt(t, word(t.treeJoints, first + i)).below;
    if (below != 0) clearBody(t, rigid, <i32>((below - t.bodies) / ARTICULATED_BODY_SIZE));
  }
}

function clearBody(t: JointTable, rigid: RigidTable, i: i32): void {
  clearRecord(changetype<usize>(massOf(t, i)), ARTICULATED_MASS_SIZE);
  if (rigid.lockedCount > 0) weighBody(t, rigid, i);
}

// Applies what the locked directions exerted, times `part`.
export function applyImpulses(t: JointTable, rigid: RigidTable, k: i32, part: f64): void {
  const at = placeAt(t, k);
  if (at.hinge != 0) return applyAtHinge(t, rigid, at, part * at.impulseX, part * at.impulseY);
  const work = workAt(t, k);
  if (work.locks == 0) return;
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const impulses = impulsesOf(t, work.id);
  applyLocks(work, a, b, part * impulses.lock0, part * impulses.lock1, part * impulses.lock2);
}

function warmStartAxes(t: JointTable, rigid: RigidTable, work: JointWork): void {
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const impulses = impulsesOf(t, work.id);
  if (work.kind == MOTOR) return applyLocks(work, a, b, impulses.lock0, impulses.lock1, impulses.lock2);
  if (work.kind == PULLEY || work.kind == GEAR) return warmStartCoupling(work, a, b, impulses);
  applyAlong(work, a, b, rowOf(work, SPRING_ROW), impulses.spring + impulses.lower - impulses.upper);
  applyAlong(work, a, b, rowOf(work, MOTOR_ROW), impulses.motor);
}
