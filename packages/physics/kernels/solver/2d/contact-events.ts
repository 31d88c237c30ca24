// What happened to contacts in a step: pairs that began to touch, pairs that no longer touch, and impacts. Then the pairs of
// a sensor and what it senses, that began and ended to overlap.
import { put } from '../../memory/columns';
import {
  ContactPoint,
  DID_OVERLAP,
  FAST_POINT,
  OVERLAPS,
  RigidContact,
  SENSES,
  SENSOR_IS_B,
  TOUCHING,
  WAS_TOUCHING,
  contactAt,
  pointOf,
} from '../../collision/narrow-phase/2d/rigid-contact';
import { poseOf, putWord, word } from './body';
import { RigidTable } from './rigid-table';

// Contacts with a point, the normal there, the speed of approach, and the impulse of the step.
@unmanaged
export class ContactEventList {
  count: i32;
  a: usize;
  b: usize;
  x: usize;
  y: usize;
  nx: usize;
  ny: usize;
  speeds: usize;
  impulses: usize;
}

// Forgets the events of the last step.
export function clearEvents(t: RigidTable): void {
  t.endCount = 0;
  t.sensorBeginCount = 0;
  t.sensorEndCount = 0;
}

// Lists the events of the present contacts; the end of a contact was recorded when it was removed.
export function listContactEvents(table: usize): void {
  const t = changetype<RigidTable>(table);
  const begins = changetype<ContactEventList>(t.begins);
  const hits = changetype<ContactEventList>(t.hits);
  begins.count = 0;
  hits.count = 0;
  for (let i = 0; i < t.currentCount; i++) {
    const contact = contactAt(t, word(t.current, i));
    if ((contact.flags & SENSES) != 0) {
      listSensorEvent(t, contact);
      continue;
    }
    const state = contact.flags & (TOUCHING | WAS_TOUCHING);
    if (state == WAS_TOUCHING) noteEnd(t, contact);
    if ((state & TOUCHING) == 0) continue;
    // Most contacts have nothing to report.
    if (state != TOUCHING && (contact.flags & FAST_POINT) == 0) continue;
    const point = fastestPoint(contact);
    if (state == TOUCHING) noteContact(t, begins, contact, point);
    if (-point.normalSpeed > <real>t.hitSpeed && point.totalImpulse != 0) noteContact(t, hits, contact, point);
  }
}

// The point at which the surfaces approached faster; of two points of which one was hit, that one.
function fastestPoint(contact: RigidContact): ContactPoint {
  const first = pointOf(contact, 0);
  if (contact.count < 2) return first;
  const second = pointOf(contact, 1);
  if ((first.totalImpulse != 0) != (second.totalImpulse != 0)) return first.totalImpulse != 0 ? first : second;
  return second.normalSpeed < first.normalSpeed ? second : first;
}

function noteContact(t: RigidTable, list: ContactEventList, contact: RigidContact, point: ContactPoint): void {
  const i = list.count++;
  const pose = poseOf(t, contact.bodyA);
  let impulse: real = 0;
  for (let p = 0; p < contact.count; p++) impulse += pointOf(contact, p).totalImpulse;
  putWord(list.a, i, contact.a);
  putWord(list.b, i, contact.b);
  put(list.x, i, pose.x + point.ax);
  put(list.y, i, pose.y + point.ay);
  put(list.nx, i, contact.nx);
  put(list.ny, i, contact.ny);
  put(list.speeds, i, -point.normalSpeed);
  put(list.impulses, i, impulse);
}

export function noteEnd(t: RigidTable, contact: RigidContact): void {
  putWord(t.endA, t.endCount, contact.a);
  putWord(t.endB, t.endCount++, contact.b);
}

function listSensorEvent(t: RigidTable, contact: RigidContact): void {
  const state = contact.flags & (OVERLAPS | DID_OVERLAP);
  const isB = (contact.flags & SENSOR_IS_B) != 0;
  if (state == OVERLAPS) noteSensorBegin(t, isB ? contact.b : contact.a, isB ? contact.a : contact.b);
  else if (state == DID_OVERLAP) noteSensorPairEnd(t, contact);
}

export function noteSensorPairEnd(t: RigidTable, contact: RigidContact): void {
  const isB = (contact.flags & SENSOR_IS_B) != 0;
  noteSensorEnd(t, isB ? contact.b : contact.a, isB ? contact.a : contact.b);
}

export function noteSensorBegin(t: RigidTable, sensor: i32, visitor: i32): void {
  if (t.sensorBeginCount == t.contactCapacity) return;
  putWord(t.sensorBeginSensors, t.sensorBeginCount, sensor);
  putWord(t.sensorBeginVisitors, t.sensorBeginCount++, visitor);
}

export function noteSensorEnd(t: RigidTable, sensor: i32, visitor: i32): void {
  if (t.sensorEndCount == t.contactCapacity) return;
  putWord(t.sensorEndSensors, t.sensorEndCount, sensor);
  putWord(t.sensorEndVisitors, t.sensorEndCount++, visitor);
}
