// The list of contacts, sorted by (a, b). Records stay where they are; the list holds their numbers.
import { clearRecord } from '../../../memory/records';
import { keyAt } from '../../broad-phase/2d/sort-keys';
import { MOVES, SENSOR, flagsOf, putWord, word } from '../../../solver/2d/body';
import { bodyOf } from '../../../solver/2d/parts';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { RIGID_CONTACT_SIZE, RigidContact, SENSES, SENSOR_IS_B, contactAt } from './rigid-contact';

// Part of the room for contacts that is reserved for pairs of a dynamic body and a static or kinematic one: 1/STATIC_PART.
const STATIC_PART: i32 = 8;

// Adds a contact for every new pair of t.pairs, which is sorted. The list is merged from its end, so that it needs no room.
export function addContacts(t: RigidTable): void {
  const added = dropKnown(t);
  const total = t.contactCount + added;
  let old = t.contactCount - 1;
  let fresh = added - 1;
  for (let i = total - 1; fresh >= 0; i--) {
    if (old >= 0 && keyOf(contactAt(t, word(t.order, old))) > keyAt(t.pairs, fresh)) {
      putWord(t.order, i, word(t.order, old--));
    } else {
      const slot = openContact(t, keyAt(t.pairs, fresh));
      putWord(t.newContacts, fresh--, slot);
      putWord(t.order, i, slot);
    }
  }
  t.contactCount = total;
  t.newPairCount = added;
}

// Reduces t.pairs to the pairs that are in no contact yet and for which there is room, once each. Returns their number. A contact
// of earlier bodies of these rows is about to end, and stays beside the new one until then.
function dropKnown(t: RigidTable): i32 {
  let kept = 0;
  let at = 0;
  let last: u64 = 0;
  const roomOfMoving = t.freeCount - t.contactCapacity / STATIC_PART;
  for (let i = 0; i < t.pairCount; i++) {
    const key = keyAt(t.pairs, i);
    while (at < t.contactCount && keyOf(contactAt(t, word(t.order, at))) < key) at++;
    if (key == last || (at < t.contactCount && isContactOf(t, contactAt(t, word(t.order, at)), key))) continue;
    last = key;
    if (kept == t.freeCount || (kept >= roomOfMoving && bothMove(t, key))) {
      t.droppedCount++;
    } else {
      store<u64>(t.pairs + ((<usize>kept) << 3), key);
      kept++;
    }
  }
  return kept;
}

// @ts-ignore: decorator
@inline function bothMove(t: RigidTable, key: u64): bool {
  return (flagsOf(t, <i32>(key >> 32)) & flagsOf(t, <i32>key) & MOVES) != 0;
}

// @ts-ignore: decorator
@inline function keyOf(contact: RigidContact): u64 {
  return ((<u64>contact.a) << 32) | <u64>contact.b;
}

// Whether it is the contact of a pair of shapes, and of the bodies to which these now belong.
function isContactOf(t: RigidTable, contact: RigidContact, key: u64): bool {
  if (keyOf(contact) != key || !isCurrent(t, contact)) return false;
  return contact.bodyA == bodyOf(t, contact.a) && contact.bodyB == bodyOf(t, contact.b);
}

// Whether the rows still hold what the contact was made for.
// @ts-ignore: decorator
@inline export function isCurrent(t: RigidTable, contact: RigidContact): bool {
  const sameA = contact.generationA == <u32>word(t.generations, contact.a);
  return sameA && contact.generationB == <u32>word(t.generations, contact.b);
}

function openContact(t: RigidTable, key: u64): i32 {
  const slot = word(t.free, --t.freeCount);
  const contact = contactAt(t, slot);
  clearRecord(changetype<usize>(contact), RIGID_CONTACT_SIZE);
  contact.a = <i32>(key >> 32);
  contact.b = <i32>key;
  contact.bodyA = bodyOf(t, contact.a);
  contact.bodyB = bodyOf(t, contact.b);
  contact.generationA = <u32>word(t.generations, contact.a);
  contact.generationB = <u32>word(t.generations, contact.b);
  if (((flagsOf(t, contact.a) | flagsOf(t, contact.b)) & SENSOR) != 0) contact.flags = sensorFlags(t, contact);
  return slot;
}

// Flags of the contact of a sensor.
export function sensorFlags(t: RigidTable, contact: RigidContact): u32 {
  return (flagsOf(t, contact.b) & SENSOR) != 0 ? SENSES | SENSOR_IS_B : SENSES;
}

export function freeContact(t: RigidTable, slot: i32): void {
  putWord(t.free, t.freeCount++, slot);
}

// Fills the list of free records, once.
export function clearContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.contactCapacity; i++) putWord(t.free, i, t.contactCapacity - 1 - i);
  t.freeCount = t.contactCapacity;
  t.contactCount = 0;
}
