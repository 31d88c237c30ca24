// Where steps differ in length. What contacts keep for the next step are impulses of a sub-step, and those of what rests are in
// proportion to its length. A step that is much shorter than recent ones also corrects the speeds that they left unsolved: those
// impulses have nothing to do with its length, and would grow by the ratio of lengths in the next long step. So contacts keep a
// weighted mean of old and new impulses, in which the new ones have the weight of the length to the recent one.
import { contactInOrder } from '../../collision/narrow-phase/2d/rigid-contact';
import { scaleContact } from './forget-impulses';
import { RigidTable } from './rigid-table';

// Multiplies the impulses of all contacts.
export function scaleContactImpulses(table: usize, factor: f64): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.contactCount; i++) scaleContact(contactInOrder(t, i), <real>factor);
}
