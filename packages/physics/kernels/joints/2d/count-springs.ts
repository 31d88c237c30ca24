// How many springs act on a body that are solved one after another, and not with their tree: those of rods and motor joints, of joints that
// close loops, and of joints whose limits or motor act in the same direction (spring-softness.ts).
import { get } from '../../memory/columns';
import { putWord, word } from '../../solver/2d/body';
import { isSpringAlone } from './engage-springs';
import { JointTable, MOTOR, isCoupling } from './joint-table';
import { JointWork, workAt } from './joint-work';
import { treeOfRow } from './list-by-tree';

// Notes at each such joint the number of the one of its bodies that has more, 0 where it is the only such spring of bodies in no tree. What joints do not
// move has none.
export function countSprings(t: JointTable): void {
  for (let i = 0; i < t.axisCount; i++) {
    const work = axisAt(t, i);
    putWord(t.marks, work.a, 0);
    putWord(t.marks, work.b, 0);
  }
  for (let i = 0; i < t.axisCount; i++) {
    const work = axisAt(t, i);
    if (!(get(t.hertz, work.id) > 0) || isCoupling(work.kind) || isSpringAlone(t, work)) continue;
    putWord(t.marks, work.a, word(t.marks, work.a) + 1);
    putWord(t.marks, work.b, word(t.marks, work.b) + 1);
  }
  for (let i = 0; i < t.axisCount; i++) {
    const work = axisAt(t, i);
    const ofA = work.a == 0 ? 0 : word(t.marks, work.a);
    const ofB = work.b == 0 ? 0 : word(t.marks, work.b);
    const most = max<i32>(1, max<i32>(ofA, ofB));
    work.springs = most == 1 && isFree(t, work) ? 0 : most;
  }
}

// Whether nothing else is joined to what a spring pulls: it is solved exactly by itself. A motor joint has springs in two directions.
function isFree(t: JointTable, work: JointWork): bool {
  return work.kind != MOTOR && treeOfRow(t, work.a) < 0 && treeOfRow(t, work.b) < 0;
}

// @ts-ignore: decorator
@inline function axisAt(t: JointTable, i: i32): JointWork {
  return workAt(t, word(t.axes, i));
}
