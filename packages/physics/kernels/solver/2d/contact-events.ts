// What happened to contacts in a step: pairs that began to touch, pairs that no longer touch, and impacts.
import { put } from '../../memory/columns';
import {
  ContactPoint,
  RigidContact,
  TOUCHING,
  WAS_TOUCHING,
  contactAt,
  pointOf,
} from '../../collision/narrow-phase/2d/rigid-contact';
import { poseOf, putWord, word } from './body';
import { RigidTable } from './rigid-table';

// Lists the events of the present contacts; the end of a contact was recorded when it was removed.
export function listContactEvents(table: usize): void {
  const t = changetype<RigidTable>(table);
  t.beginCount = 0;
  t.hitCount = 0;
  for (let i = 0; i < t.contactCount; i++) {
    const contact = contactAt(t, word(t.order, i));
    const state = contact.flags & (TOUCHING | WAS_TOUCHING);
    if (state == TOUCHING) {
      putWord(t.beginA, t.beginCount, contact.a);
      putWord(t.beginB, t.beginCount++, contact.b);
    } else if (state == WAS_TOUCHING) {
      noteEnd(t, contact);
    }
    if ((state & TOUCHING) != 0) noteHit(t, contact);
  }
}

export function noteEnd(t: RigidTable, contact: RigidContact): void {
  putWord(t.endA, t.endCount, contact.a);
  putWord(t.endB, t.endCount++, contact.b);
}

// The faster of the points that were hit.
function noteHit(t: RigidTable, contact: RigidContact): void {
  let speed = <real>t.hitSpeed;
  let hit = changetype<ContactPoint>(0);
  for (let p = 0; p < contact.count; p++) {
    const point = pointOf(contact, p);
    if (-point.normalSpeed <= speed || point.totalImpulse == 0) continue;
    speed = -point.normalSpeed;
    hit = point;
  }
  if (changetype<usize>(hit) == 0) return;
  const i = t.hitCount++;
  const pose = poseOf(t, contact.bodyA);
  putWord(t.hitA, i, contact.a);
  putWord(t.hitB, i, contact.b);
  put(t.hitX, i, pose.x + hit.ax);
  put(t.hitY, i, pose.y + hit.ay);
  put(t.hitNx, i, contact.nx);
  put(t.hitNy, i, contact.ny);
  put(t.hitSpeeds, i, speed);
}
