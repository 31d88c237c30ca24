// What springs do to a tree, and motors that push with all they have. Their joints pass it on at once: as impulses on the bodies of the
// tree, among those of all joints. Done to their two bodies alone it would turn a light one on which much hangs a hundred times as
// fast, and a soft pass leaves a part of that for the positions (softness.ts).
import { get } from '../../memory/columns';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { pushBody } from './articulated-body';
import { JointTable, impulsesOf, isSolvedApart } from './joint-table';
import { LOOP, treeBody } from './joint-trees';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, stateA, stateB } from './joint-rows';

// Takes back what the spring of a joint has done to its two bodies: the tree bears it in this pass.
export function bearSpring(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  work.springPush = 0;
  if (work.hasAxes == 0 || work.parent == LOOP || isSolvedApart(work.kind) || !(get(t.hertz, work.id) > 0)) return;
  work.springPush = impulsesOf(t, work.id).spring;
  applyAlong(work, stateA(rigid, work), stateB(rigid, work), rowOf(work, SPRING_ROW), -work.springPush);
}

// After a soft pass, which moves bodies by a part only of what was pushed: the rest follows when joints are relaxed.
export function leaveRest(work: JointWork): void {
  const rest = 1 - softness.massScale;
  work.push *= rest;
  work.springPush *= rest;
}

// Before a tree is gathered: adds what is pushed to the momentum of both bodies.
export function pushAxes(t: JointTable, k: i32): void {
  const work = workAt(t, k);
  if (work.push != 0) pushAlong(t, work, rowOf(work, MOTOR_ROW), work.push);
  if (work.springPush != 0) pushAlong(t, work, rowOf(work, SPRING_ROW), work.springPush);
}

function pushAlong(t: JointTable, work: JointWork, row: JointRow, impulse: f64): void {
  pushBody(treeBody(t, work.a), -impulse * row.x, -impulse * row.y, -impulse * row.armA);
  pushBody(treeBody(t, work.b), impulse * row.x, impulse * row.y, impulse * row.armB);
}
