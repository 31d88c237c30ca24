// Velocities of semi-implicit Euler lag: what flies with the acceleration a has v + a h/2 after sub-steps of h seconds. That is the speed
// to turn around. To turn v around loses (1 + e) a h/2 in each bounce: with e = 1 a ball that falls 2 m falls 1 m after half a minute.
// So bodies that flew into an impact are brought up to their speed for its rounds. Others, which contacts or joints bore when the
// step began, do not gain what their force would give them.
import { pointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import { get } from '../../memory/columns';
import { JOINED, flagsOf, stateOf } from '../../solver/2d/body';
import { contactOf } from '../../solver/2d/contact-place';
import { inverseMassX, inverseMassY } from '../../solver/2d/motion-locks';
import { RigidTable } from '../../solver/2d/rigid-table';
import { firstEdge, nextEdge, visit } from './contact-edges';
import { impactAt } from './impact';

// The searches before and after all rounds.
const FORWARD: i32 = -2;
const BACK: i32 = -3;

// Gives the bodies of the first `count` impacts that flew what their force gives in half a sub-step, or takes it back.
export function halfKick(t: RigidTable, count: i32, takesBack: bool): void {
  const time = <real>((takesBack ? -0.5 : 0.5) * t.h);
  const search = takesBack ? BACK : FORWARD;
  for (let i = 0; i < count; i++) {
    accelerate(t, impactAt(t, i).rowA, time, search);
    accelerate(t, impactAt(t, i).rowB, time, search);
  }
}

function accelerate(t: RigidTable, row: i32, time: real, search: i32): void {
  if (!visit(t, row, search) || !flew(t, row)) return;
  const state = stateOf(t, row);
  state.vx += time * inverseMassX(t, row) * get(t.forceX, row);
  state.vy += time * inverseMassY(t, row) * get(t.forceY, row);
}

// Whether neither contacts nor joints held a body when the step began.
function flew(t: RigidTable, row: i32): bool {
  if ((flagsOf(t, row) & JOINED) != 0) return false;
  for (let edge = firstEdge(t, row); edge >= 0; edge = nextEdge(t, edge)) {
    const contact = contactOf(t, edge >> 1);
    for (let i = 0; i < contact.count; i++) if (pointOf(contact, i).normalImpulse != 0) return false;
  }
  return true;
}
