// Where steps differ in length. What contacts keep for the next step are impulses of a sub-step, and those of what rests are in
// proportion to its length. A step that is much shorter than those of late also ends what they left unsolved: impulses of speeds,
// not of forces, which would grow by the ratio of lengths in the next long step. Of such a step's impulses only the part that is
// its length to that of late is kept (RigidTable.kept), of what was kept before the rest.
import { contactAt, pointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import { word } from './body';
import { RigidTable } from './rigid-table';

// Multiplies the impulses of all contacts.
export function scaleContactImpulses(table: usize, factor: f64): void {
  const t = changetype<RigidTable>(table);
  const by = <real>factor;
  for (let i = 0; i < t.contactCount; i++) {
    const contact = contactAt(t, word(t.order, i));
    contact.rollingImpulse *= by;
    for (let p = 0; p < contact.count; p++) {
      const point = pointOf(contact, p);
      point.normalImpulse *= by;
      point.tangentImpulse *= by;
    }
  }
}
