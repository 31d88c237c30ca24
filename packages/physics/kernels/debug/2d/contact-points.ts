// The contact points of rigid bodies, one after the other, for pictures and logs.
import { columns, get } from '../../memory/columns';
import {
  COVERED,
  ContactPoint,
  RigidContact,
  TOUCHING,
  contactAt,
  pointOf,
  slotInOrder,
} from '../../collision/narrow-phase/2d/rigid-contact';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';

@unmanaged
export class ContactView {
  // Rows, a < b.
  a: i32;
  b: i32;
  // Colour in which the solver took it, -1 if it had nothing to do; and the next entry of the solver's list.
  color: i32;
  next: i32;
  // Point, m, from where a is now; unit normal from a to b; distance of the surfaces when the step began, m; impulse of
  // the step along the normal, N s; speed at which the surface of b slides along that of a in the direction (n_y, -n_x), m/s.
  x: real;
  y: real;
  nx: real;
  ny: real;
  separation: real;
  impulse: real;
  slip: real;
}

// Writes the first point from `cursor` on to the record at `view`, and returns the cursor behind it, 0 after the last. The
// first cursor is 0.
export function nextContactPoint(table: usize, view: usize, cursor: i32): i32 {
  const t = changetype<RigidTable>(table);
  const to = changetype<ContactView>(view);
  if (cursor == 0) to.next = 0;
  for (let at = cursor; at < 2 * t.contactCount; at++) {
    const slot = slotInOrder(t, at >> 1);
    const contact = contactAt(t, slot);
    const index = at & 1;
    // The solver's list has the same order.
    const isSolved = to.next < t.touchingCount && word(t.touching, 2 * to.next) == slot;
    to.color = isSolved ? word(t.touching, 2 * to.next + 1) : -1;
    if (isSolved && index == 1) to.next++;
    if (index >= contact.count || (contact.flags & (TOUCHING | COVERED)) != TOUCHING) continue;
    const point = pointOf(contact, index);
    const c = columns();
    to.a = contact.a;
    to.b = contact.b;
    to.x = get(c.positionX, contact.bodyA) + point.ax;
    to.y = get(c.positionY, contact.bodyA) + point.ay;
    to.nx = contact.nx;
    to.ny = contact.ny;
    to.separation = point.separation;
    to.impulse = point.totalImpulse;
    to.slip = slipAt(contact, point);
    return at + 1;
  }
  return 0;
}

// As the velocities are now, beyond that at which the surfaces themselves run, as conveyor belts do.
function slipAt(contact: RigidContact, point: ContactPoint): real {
  const c = columns();
  const wA = get(c.angularVelocityZ, contact.bodyA);
  const wB = get(c.angularVelocityZ, contact.bodyB);
  const vx = get(c.velocityX, contact.bodyB) - wB * point.by - (get(c.velocityX, contact.bodyA) - wA * point.ay);
  const vy = get(c.velocityY, contact.bodyB) + wB * point.bx - (get(c.velocityY, contact.bodyA) + wA * point.ax);
  return contact.ny * vx - contact.nx * vy - contact.tangentSpeed;
}
