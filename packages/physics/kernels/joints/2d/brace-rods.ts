// Rods and ropes that are pulled hard. The force F along a rod of length l turns with it: where an end moves across it by s, it
// pulls back by F s/l, as a spring of stiffness F/l does. On the mass m that the ends of both bodies have across the rod it swings with
// the frequency √(F/(l m)). For a short rod between light bodies this is more than sub-steps of h seconds can follow: the ends are
// thrown to and fro ever farther, the rod becomes too long, what pulls it together makes F larger, and it tears.
//
// So beyond h² F/l = m the pull has the direction that the rod will have at the end of the sub-step, as an implicit step would see it:
// in the matrix of its tree stands one more row, across the rod, which resists speed as if h² F/l - m more were at rest there. It
// takes energy and gives none. So does the inertia that a body gets beyond its own where rods pull at its ends and turn it back with
// k = r · F per radian, until it is h² k. To raise its inertia in all respects, as brace-joints.ts does for a whole step, would not do for
// pulls that come and go: a body that spins would gain energy.
//
// F is what the rod exerts while it closes gaps, before that part is taken back: it moves the bodies. It is known from the sub-step
// before; the greatest of late counts, because a rod that jerks pulls in some sub-steps only.
// Sources: Tournier et al., Stable Constrained Dynamics (SIGGRAPH 2015); Andrews et al., Geometric Stiffness for Real-time
// Constrained Multibody Dynamics (Eurographics 2017).
import { get } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { articulated, massOf } from './articulated-body';
import { jointed, stiffen } from './brace-joints';
import { JointImpulses, JointTable, impulsesOf } from './joint-table';
import { coupling } from './joint-rows';
import { JointRow, JointWork, SPRING_ROW, rowOf, workAt } from './joint-work';

// The row across a rod: one after those that a rod can lock.
export const ACROSS: i32 = 2;

// How much of the greatest pull is left after a sub-step.
const KEPT: f64 = 0.5;

// Notes the greatest pull of late, after a rod or a rope in a tree has exerted an impulse along its only locked direction.
// @ts-ignore: decorator
@inline export function notePull(impulses: JointImpulses, before: f64): void {
  impulses.lock1 = max<f64>(-impulses.lock0, KEPT * before);
}

// The greatest pull of late in a sub-step, N s.
function pullOf(t: JointTable, work: JointWork): f64 {
  const impulses = impulsesOf(t, work.id);
  const now = impulses.upper - impulses.lower - impulses.lock0;
  // A rod that pushes has nothing to be kept from.
  if (!(now > 0)) return 0;
  return max<f64>(max<f64>(now, impulses.lock1), impulses.force * changetype<RigidTable>(t.rigid).h);
}

// What a rod or a rope does to its bodies when these turn (brace-joints.ts).
export function stiffenByRod(t: JointTable, work: JointWork): void {
  if (get(t.hertz, work.id) > 0) return;
  const along = rowOf(work, SPRING_ROW);
  const impulses = impulsesOf(t, work.id);
  const pull = impulses.upper - impulses.lower - impulses.lock0;
  stiffen(t, work.a, pull * along.x, pull * along.y, work.rax, work.ray);
  stiffen(t, work.b, pull * along.x, pull * along.y, -work.rbx, -work.rby);
}

// Makes the row across a rod or a rope in a tree, where it is pulled too hard for its length. Its direction is known.
export function braceRod(t: JointTable, work: JointWork, length: f64): void {
  const along = rowOf(work, SPRING_ROW);
  const row = rowOf(work, ACROSS);
  row.x = -along.y;
  row.y = along.x;
  row.armA = work.rax * along.x + work.ray * along.y;
  row.armB = work.rbx * along.x + work.rby * along.y;
  const pull = pullOf(t, work);
  jointed(t, work.a).rodStiffness += max<f64>(0, pull * row.armA);
  jointed(t, work.b).rodStiffness += max<f64>(0, -pull * row.armB);
  const excess = (changetype<RigidTable>(t.rigid).h * pull) / length - 1 / coupling(work, row, row);
  if (excess > 0) work.acrossInverse = 1 / excess;
  else release(work);
}

function release(work: JointWork): void {
  work.acrossInverse = 0;
  memory.fill(changetype<usize>(rowOf(work, ACROSS)), 0, offsetof<JointRow>());
}

// Begins a sub-step.
export function startRods(t: JointTable): void {
  for (let i = 0; i < t.bodyCount; i++) jointed(t, word(t.bodyRows, i)).rodStiffness = 0;
}

// Bodies that rods pull harder than their inertia can follow resist turning as if they had the inertia that can.
export function braceTurns(t: JointTable, rigid: RigidTable): void {
  for (let i = 0; i < t.bodyCount; i++) {
    const excess = rigid.h * jointed(t, word(t.bodyRows, i)).rodStiffness - articulated(t, i).inertia;
    if (excess > 0) massOf(t, i).m22 += excess;
  }
}

// An impact is over before anything has turned.
export function releaseRods(t: JointTable): void {
  startRods(t);
  for (let k = 0; k < t.closedCount; k++) if (workAt(t, k).acrossInverse > 0) release(workAt(t, k));
}
