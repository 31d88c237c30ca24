// What springs do to a tree in whose matrix they are not (engage-springs.ts), and motors that push with all they have. Their joints pass
// it on at once: as impulses on the bodies of the tree, among those of all joints. Done to their two bodies alone it would turn a light one on which much hangs a hundred times as
// fast, and a soft pass leaves a part of that for the positions (softness.ts). Such a pass moves bodies by a part only of what is
// pushed: it is given so much more that all of it acts before positions follow. What comes after them is a force of a moment ago, with
// which springs gain energy, and what motors press slips.
import { get } from '../../memory/columns';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { pushBody } from './articulated-body';
import { JointTable, impulsesOf, isSolvedApart } from './joint-table';
import { LOOP, treeBody } from './joint-trees';
import { JointRow, JointWork, MOTOR_ROW, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, stateA, stateB } from './joint-rows';

// Takes back what the spring of a joint has done to its two bodies: the tree bears it in this pass, a soft one.
export function bearSpring(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  work.springPush = 0;
  if (work.hasAxes == 0 || work.parent == LOOP || isSolvedApart(work.kind) || !(get(t.hertz, work.id) > 0)) return;
  const impulse = impulsesOf(t, work.id).spring;
  work.springPush = impulse / softness.massScale;
  applyAlong(work, stateA(rigid, work), stateB(rigid, work), rowOf(work, SPRING_ROW), -impulse);
}

// After a soft pass nothing is left to push.
export function endPush(work: JointWork): void {
  work.push = 0;
  work.springPush = 0;
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
