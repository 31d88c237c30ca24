// The loops of a mechanism, closed exactly and at once with its tree. Joints of a tree bring any velocities v to P(v), which is
// affine in v (solve-locks.ts). Impulses λ of the joints that close loops, whose Jacobian is L, change that by T λ. They are to be
// such that these joints are as they want to be:
//
//   L (P(v) + T λ) = -r C - c                (L T + E) λ = -r C - c - L P(v)
//
// A column of T is what the tree does under an impulse of 1 along one locked direction. L T is symmetric and positive
// semidefinite. E is a little compliance, so that what is held twice, as in a truss with more bars than it needs, has a solution.
// Then the tree is solved once more with λ among the impulses on its bodies. What joints exerted before does not matter, as in trees.
// Pulleys and gears are directions of this kind, too, by which several trees may hang together.
// Source: Featherstone, Rigid Body Dynamics Algorithms (2008), section 8.5 (loop-closure forces).
import { stateOf } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, pushBody } from './articulated-body';
import { ACROSS, notePull } from './brace-rods';
import { clearHeldTwice } from './held-twice';
import { coupling, finite } from './joint-rows';
import { DISTANCE, GEAR, JointImpulses, JointTable, PULLEY, impulsesOf, isCoupling, lockAddress } from './joint-table';
import { treeBody } from './joint-trees';
import { JointRow, JointWork, rowOf, workAt } from './joint-work';
import { LOOP_ROW, LoopRow, clearDirection, loopRow } from './loop-row';
import { pushAxes } from './push-axes';
import { Mechanism, mechanismAt, treeOfMechanism } from './mechanisms';
import { ROW_A, ROW_B, giveOfRope, inverseMassOf } from './solve-couplings';
import { factorSymmetric, solveSymmetric } from './symmetric-matrix';
import { gatherTree, passTree, respond } from './sweep-tree';

// Of the inverse mass that both bodies of a joint have by themselves: how much it gives way. Where bars stretch to a line, a loop can
// follow hardly any error, and what rounding leaves of one must not throw them about.
const COMPLIANCE: f64 = 1e-5;

// Closes the loops of all mechanisms, whose trees are gathered and wait for the velocities of their roots.
export function closeAllLoops(t: JointTable, rigid: RigidTable, bias: f64, soft: bool, factor: bool): void {
  for (let i = 0; i < t.mechanismCount; i++) {
    const mechanism = mechanismAt(t, i);
    closeLoops(t, rigid, mechanism, bias, soft, factor);
    for (let k = 0; k < mechanism.rows; k++) keepImpulse(loopRow(t, k), soft);
    for (let k = 0; soft && k < mechanism.count; k++) {
      const work = workAt(t, mechanism.first + k);
      if (work.kind == DISTANCE) notePull(impulsesOf(t, work.id), impulsesOf(t, work.id).lock1);
    }
  }
}

// Of impacts the impulses are no load of the joints.
export function closeLoops(
  t: JointTable,
  rigid: RigidTable,
  mechanism: Mechanism,
  bias: f64,
  soft: bool,
  factor: bool,
): void {
  const scale = softness.massScale;
  // Bodies keep their velocities while what the trees would do is tried.
  softness.massScale = 0;
  listRows(t, rigid, mechanism, bias);
  for (let i = 0; i < mechanism.trees; i++) passTree(t, rigid, treeOfMechanism(t, mechanism, i), soft);
  for (let i = 0; i < mechanism.rows; i++) {
    const row = loopRow(t, i);
    row.value = speedAlong(row) + row.wanted;
    // Limits were let go since: what gave way against them is not to stay as a speed.
    if (factor && !soft) row.value += row.compliance * load<f64>(row.impulse);
  }
  if (factor) factorLoops(t, mechanism);
  solveSymmetric(mechanism.matrix, mechanism.rows, t.loopRows + offsetof<LoopRow>('value'), LOOP_ROW);
  for (let i = 0; i < mechanism.rows; i++) {
    const row = loopRow(t, i);
    row.value = -finite(row.value);
    push(row, row.value);
  }
  for (let i = 0; i < mechanism.count; i++) pushAxes(t, mechanism.first + i);
  for (let i = 0; i < mechanism.trees; i++) gatherTree(t, rigid, treeOfMechanism(t, mechanism, i), bias, soft, false);
  softness.massScale = scale;
}

// What the bodies of a mechanism of a single tree do that is at rest, and whose loops are to stay closed, under an impulse on one of
// them: their velocities. Its directions have been listed.
export function respondClosed(t: JointTable, mechanism: Mechanism, body: usize, x: f64, y: f64, turn: f64): void {
  const tree = treeOfMechanism(t, mechanism, 0);
  pushBody(body, x, y, turn);
  respond(t, tree);
  for (let i = 0; i < mechanism.rows; i++) loopRow(t, i).value = speedAlong(loopRow(t, i));
  solveSymmetric(mechanism.matrix, mechanism.rows, t.loopRows + offsetof<LoopRow>('value'), LOOP_ROW);
  pushBody(body, x, y, turn);
  for (let i = 0; i < mechanism.rows; i++) push(loopRow(t, i), -finite(loopRow(t, i).value));
  respond(t, tree);
}

// Lists the directions of a mechanism as its bodies are now.
export function listRows(t: JointTable, rigid: RigidTable, mechanism: Mechanism, bias: f64): void {
  mechanism.rows = 0;
  for (let i = 0; i < mechanism.count; i++) {
    const work = workAt(t, mechanism.first + i);
    if (isCoupling(work.kind)) listCoupling(t, rigid, mechanism, work, bias);
    const first = mechanism.rows;
    for (let p = 0; p < work.locks; p++) listLock(t, mechanism, work, p, bias);
    clearHeldTwice(t, work, first, first + work.ownLocks);
    if (work.acrossInverse > 0) listLock(t, mechanism, work, ACROSS, bias);
  }
}

function listLock(t: JointTable, mechanism: Mechanism, work: JointWork, p: i32, bias: f64): void {
  const row = rowOf(work, p);
  const to = startRow(t, mechanism, work, row, bias);
  to.ax = -row.x;
  to.ay = -row.y;
  to.aw = -row.armA;
  to.bx = row.x;
  to.by = row.y;
  to.bw = row.armB;
  to.impulse = lockAddress(impulsesOf(t, work.id), p);
  to.inverseMass = coupling(work, row, row);
  to.compliance = COMPLIANCE * to.inverseMass + (p < work.locks ? 0 : work.acrossInverse);
}

// A gear or a pulley. A rope that is slack is a direction in which nothing moves: matrices keep their size until they are made again.
function listCoupling(t: JointTable, rigid: RigidTable, mechanism: Mechanism, work: JointWork, bias: f64): void {
  const p = rowOf(work, ROW_A);
  const q = rowOf(work, ROW_B);
  const to = startRow(t, mechanism, work, q, bias);
  const impulses = changetype<usize>(impulsesOf(t, work.id));
  to.impulse = impulses + (work.kind == GEAR ? offsetof<JointImpulses>('lock0') : offsetof<JointImpulses>('upper'));
  if (work.kind == PULLEY && work.limit == 0) return clearDirection(to);
  to.ax = p.x;
  to.ay = p.y;
  to.aw = p.armA;
  to.bx = q.x;
  to.by = q.y;
  to.bw = q.armB;
  to.inverseMass = inverseMassOf(work);
  to.compliance = (work.kind == PULLEY ? COMPLIANCE + giveOfRope(t, rigid, work) : COMPLIANCE) * to.inverseMass;
  const a = stateOf(rigid, work.a);
  const b = stateOf(rigid, work.b);
  if (to.a == 0) to.wanted += p.x * <f64>a.vx + p.y * <f64>a.vy + p.armA * <f64>a.w;
  if (to.b == 0) to.wanted += q.x * <f64>b.vx + q.y * <f64>b.vy + q.armB * <f64>b.w;
}

function startRow(t: JointTable, mechanism: Mechanism, work: JointWork, row: JointRow, bias: f64): LoopRow {
  const to = loopRow(t, mechanism.rows++);
  to.a = treeBody(t, work.a);
  to.b = treeBody(t, work.b);
  to.wanted = bias * work.reach * row.error + row.chord;
  return to;
}

// How fast the bodies of the trees move along a direction.
// @ts-ignore: decorator
@inline function speedAlong(row: LoopRow): f64 {
  let speed: f64 = 0;
  if (row.a != 0) {
    const a = changetype<ArticulatedBody>(row.a);
    speed = row.ax * a.vx + row.ay * a.vy + row.aw * a.w;
  }
  if (row.b == 0) return speed;
  const b = changetype<ArticulatedBody>(row.b);
  return speed + (row.bx * b.vx + row.by * b.vy + row.bw * b.w);
}

// Adds an impulse along a direction to what hangs on both bodies.
function push(row: LoopRow, impulse: f64): void {
  pushBody(row.a, impulse * row.ax, impulse * row.ay, impulse * row.aw);
  pushBody(row.b, impulse * row.bx, impulse * row.by, impulse * row.bw);
}

// Makes the matrix L T + E by one impulse along each direction, and factors it. A direction in which nothing can move has no impulse.
function factorLoops(t: JointTable, mechanism: Mechanism): void {
  const n = mechanism.rows;
  for (let i = 0; i < n; i++) {
    const from = loopRow(t, i);
    const line = mechanism.matrix + ((<usize>(i * n)) << 3);
    memory.fill(line, 0, (<usize>n) << 3);
    if (!(from.inverseMass > 0)) continue;
    push(from, 1);
    for (let k = 0; k < mechanism.trees; k++) respond(t, treeOfMechanism(t, mechanism, k));
    for (let j = 0; j <= i; j++) store<f64>(line + ((<usize>j) << 3), speedAlong(loopRow(t, j)));
    const diagonal = line + ((<usize>i) << 3);
    store<f64>(diagonal, load<f64>(diagonal) + from.compliance);
  }
  factorSymmetric(mechanism.matrix, n);
}

// @ts-ignore: decorator
@inline function keepImpulse(row: LoopRow, soft: bool): void {
  const before = soft ? 0 : load<f64>(row.impulse);
  store<f64>(row.impulse, before + softness.massScale * row.value);
}
