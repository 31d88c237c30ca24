// What contacts keep for the next step are impulses of a sub-step. Where a body became lighter since, or of another kind, they belong to
// another load: on a hundredth of the mass they are a hundred times the speed.
//
//   λ' = λ m'/m            of a contact whose reduced mass was m and is m', if it became less
//   λ' = min(λ, m v)       of all contacts that hang together with a body that is of another kind now, moved by forces or not: they keep
//                          what piles bear, and not what a press did that is none any more
import { isCurrent } from '../../collision/narrow-phase/2d/contact-list';
import { RigidContact, TOUCHING, contactInOrder, pointOf } from '../../collision/narrow-phase/2d/rigid-contact';
import { CHANGED_KIND, DYNAMIC, LIGHTER, flagsOf, poseOf, putFlags } from './body';
import { RigidTable } from './rigid-table';
import { sleeperOf } from './sleeper';

// The speed v that the impulses of a sub-step may give to what hangs together with such a body, m/s: a pile of twelve boxes bears as much.
const MOST_SPEED: real = 1;

// Passes in which such bodies are searched: over what is far away nothing is pressed.
const MOST_PASSES: i32 = 16;

export function forgetImpulses(t: RigidTable): void {
  for (let pass = 0; t.changedKindCount > 0 && pass < MOST_PASSES && spread(t); pass++) {}
  for (let i = 0; i < t.contactCount; i++) {
    const contact = contactInOrder(t, i);
    const flags = flagsOf(t, contact.bodyA) | flagsOf(t, contact.bodyB);
    if ((flags & CHANGED_KIND) != 0) scaleContact(contact, partOfSpeed(t, contact));
    else if ((flags & LIGHTER) != 0) scaleContact(contact, partOfMass(t, contact));
  }
}

// Bodies that are pushed and touch one that is of another kind count as such, too. Returns whether there are more of them now.
function spread(t: RigidTable): bool {
  let any = false;
  for (let i = 0; i < t.contactCount; i++) {
    const contact = contactInOrder(t, i);
    if ((contact.flags & TOUCHING) == 0 || !isCurrent(t, contact)) continue;
    const flagsA = flagsOf(t, contact.bodyA);
    const flagsB = flagsOf(t, contact.bodyB);
    if (((flagsA ^ flagsB) & CHANGED_KIND) == 0) continue;
    const isA = (flagsB & CHANGED_KIND) != 0;
    const flags = isA ? flagsA : flagsB;
    if ((flags & DYNAMIC) == 0) continue;
    putFlags(t, isA ? contact.bodyA : contact.bodyB, flags | CHANGED_KIND);
    any = true;
  }
  return any;
}

function partOfSpeed(t: RigidTable, contact: RigidContact): real {
  let impulse: real = 0;
  for (let p = 0; p < contact.count; p++) impulse += pointOf(contact, p).normalImpulse;
  const speed = impulse * (poseOf(t, contact.bodyA).inverseMass + poseOf(t, contact.bodyB).inverseMass);
  return speed > MOST_SPEED ? MOST_SPEED / speed : 1;
}

function partOfMass(t: RigidTable, contact: RigidContact): real {
  const before = formerInverseMass(t, contact.bodyA) + formerInverseMass(t, contact.bodyB);
  return min<real>(1, before / (poseOf(t, contact.bodyA).inverseMass + poseOf(t, contact.bodyB).inverseMass));
}

function formerInverseMass(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & LIGHTER) != 0 ? sleeperOf(t, row).formerInverseMass : poseOf(t, row).inverseMass;
}

export function scaleContact(contact: RigidContact, by: real): void {
  contact.rollingImpulse *= by;
  for (let p = 0; p < contact.count; p++) {
    const point = pointOf(contact, p);
    point.normalImpulse *= by;
    point.tangentImpulse *= by;
  }
}
