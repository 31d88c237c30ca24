// The loops of a mechanism, closed exactly and at once with its tree. Joints of a tree bring any velocities v to P(v), which is
// affine in v (solve-locks.ts). Impulses λ of the joints that close loops, whose Jacobian is L, change that by T λ. They are to be
// such that these joints are as they want to be:
//
//   L (P(v) + T λ) = -r C - c                (L T + E) λ = -r C - c - L P(v)
//
// A column of T is what the tree does under an impulse of 1 along one locked direction. L T is symmetric and positive
// semidefinite. E is a little compliance, so that what is held twice, as in a truss with more bars than it needs, has a solution.
// Then the tree is solved once more with λ among the impulses on its bodies. What joints exerted before does not matter, as in trees.
// Source: Featherstone, Rigid Body Dynamics Algorithms (2008), section 8.5 (loop-closure forces).
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, articulated } from './articulated-body';
import { coupling, finite } from './joint-rows';
import { JointTable, impulsesOf, lockAddress } from './joint-table';
import { bodyIndexOf } from './joint-trees';
import { JointRow, JointWork, rowOf, workAt } from './joint-work';
import { Mechanism, mechanismAt } from './mechanisms';
import { factorSymmetric, solveSymmetric } from './symmetric-matrix';
import { gatherTree, passTree, respond } from './sweep-tree';

// A locked direction of a joint that closes a loop.
@unmanaged
export class LoopRow {
  work: usize;
  row: usize;
  // Both bodies, class ArticulatedBody.
  a: usize;
  b: usize;
  // Where its impulse stands, and the inverse mass of both bodies along it, 1/kg.
  lock: usize;
  pad: usize;
  inverseMass: f64;
  // By how much it moves otherwise than it wants, m/s, then what is exerted along it, N s.
  value: f64;
}

const SIZE: usize = offsetof<LoopRow>();

// Of the inverse mass that both bodies of a joint have by themselves: how much it gives way. Where bars stretch to a line, a loop can
// follow hardly any error, and what rounding leaves of one must not throw them about.
const COMPLIANCE: f64 = sizeof<real>() == 4 ? 1e-5 : 1e-6;

// @ts-ignore: decorator
@inline function loopRow(t: JointTable, i: i32): LoopRow {
  return changetype<LoopRow>(t.loopRows + <usize>i * SIZE);
}

// Closes the loops of all mechanisms, whose trees are gathered and wait for the velocities of their roots.
export function closeAllLoops(t: JointTable, rigid: RigidTable, bias: f64, soft: bool, factor: bool): void {
  for (let i = 0; i < t.mechanismCount; i++) {
    const mechanism = mechanismAt(t, i);
    closeLoops(t, rigid, mechanism, bias, soft, factor);
    for (let k = 0; k < mechanism.rows; k++) keepImpulse(loopRow(t, k), soft);
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
  const tree = mechanism.tree;
  // Bodies keep their velocities while what the tree would do is tried.
  softness.massScale = 0;
  listRows(t, mechanism);
  passTree(t, rigid, tree, soft);
  for (let i = 0; i < mechanism.rows; i++)
    loopRow(t, i).value = speedAlong(loopRow(t, i)) + wanted(loopRow(t, i), bias);
  if (factor) factorLoops(t, mechanism);
  solveSymmetric(mechanism.matrix, mechanism.rows, t.loopRows + offsetof<LoopRow>('value'), SIZE);
  for (let i = 0; i < mechanism.rows; i++) {
    const row = loopRow(t, i);
    row.value = -finite(row.value);
    push(row, row.value);
  }
  gatherTree(t, rigid, tree, bias, soft);
  softness.massScale = scale;
}

function listRows(t: JointTable, mechanism: Mechanism): void {
  let count = 0;
  for (let i = 0; i < mechanism.count; i++) {
    const work = workAt(t, mechanism.first + i);
    for (let p = 0; p < work.locks; p++) fillRow(t, loopRow(t, count++), work, p);
  }
  mechanism.rows = count;
}

function fillRow(t: JointTable, to: LoopRow, work: JointWork, p: i32): void {
  const row = rowOf(work, p);
  to.work = changetype<usize>(work);
  to.row = changetype<usize>(row);
  to.a = changetype<usize>(articulated(t, bodyIndexOf(t, work.a)));
  to.b = changetype<usize>(articulated(t, bodyIndexOf(t, work.b)));
  to.lock = lockAddress(impulsesOf(t, work.id), p);
  to.inverseMass = coupling(work, row, row);
}

// How fast the bodies of the tree move along a direction.
// @ts-ignore: decorator
@inline function speedAlong(along: LoopRow): f64 {
  const row = changetype<JointRow>(along.row);
  const a = changetype<ArticulatedBody>(along.a);
  const b = changetype<ArticulatedBody>(along.b);
  return row.x * (b.vx - a.vx) + row.y * (b.vy - a.vy) + row.armB * b.w - row.armA * a.w;
}

// The speed by which it is to close: what closes the gap, and the chord (chords.ts).
// @ts-ignore: decorator
@inline function wanted(along: LoopRow, bias: f64): f64 {
  const row = changetype<JointRow>(along.row);
  return bias * changetype<JointWork>(along.work).reach * row.error + row.chord;
}

// Adds an impulse along a direction to what hangs on both bodies.
function push(along: LoopRow, impulse: f64): void {
  const row = changetype<JointRow>(along.row);
  const a = changetype<ArticulatedBody>(along.a);
  const b = changetype<ArticulatedBody>(along.b);
  a.gx -= impulse * row.x;
  a.gy -= impulse * row.y;
  a.gw -= impulse * row.armA;
  b.gx += impulse * row.x;
  b.gy += impulse * row.y;
  b.gw += impulse * row.armB;
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
    respond(t, mechanism.tree);
    for (let j = 0; j <= i; j++) store<f64>(line + ((<usize>j) << 3), speedAlong(loopRow(t, j)));
    const diagonal = line + ((<usize>i) << 3);
    store<f64>(diagonal, load<f64>(diagonal) + COMPLIANCE * from.inverseMass);
  }
  factorSymmetric(mechanism.matrix, n);
}

// @ts-ignore: decorator
@inline function keepImpulse(row: LoopRow, soft: bool): void {
  const before = soft ? 0 : load<f64>(row.lock);
  store<f64>(row.lock, before + softness.massScale * row.value);
}
