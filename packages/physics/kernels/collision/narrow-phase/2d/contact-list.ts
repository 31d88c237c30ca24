// The list of contacts, sorted by (a, b). Records stay where they are; the list holds their numbers, and the pairs as keys, so that a
// step goes past the contacts of what sleeps without reading their records.
import { clearRecord } from '../../../memory/records';
import { firstOf, secondOf } from '../../broad-phase/2d/pair-filter';
import { keyAt, putKey } from '../../broad-phase/2d/sort-keys';
import { MOVES, SENSOR, flagsOf, putWord, word } from '../../../solver/2d/body';
import { bodyOf } from '../../../solver/2d/parts';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { RIGID_CONTACT_SIZE, RigidContact, SENSES, SENSOR_IS_B, contactAt, contactInOrder } from './rigid-contact';

// Part of the room for contacts that is reserved for pairs of a dynamic body and a static or kinematic one: 1/STATIC_PART.
const STATIC_PART: i32 = 8;

// Adds a contact for every new pair of t.pairs, which is sorted. The list is merged from its end, so that it needs no room.
export function addContacts(t: RigidTable): void {
  const added = dropKnown(t);
  const total = t.contactCount + added;
  let old = t.contactCount - 1;
  let fresh = added - 1;
  for (let i = total - 1; fresh >= 0; i--) {
    if (old >= 0 && keyAt(t.keys, old) > keyAt(t.pairs, fresh)) {
      moveEntry(t, old--, i);
    } else {
      const key = keyAt(t.pairs, fresh);
      const slot = openContact(t, key);
      putWord(t.newContacts, fresh--, slot);
      putWord(t.order, i, slot);
      putKey(t.keys, i, key);
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
    while (at < t.contactCount && keyAt(t.keys, at) < key) at++;
    if (key == last || (at < t.contactCount && keyAt(t.keys, at) == key && isContactOfNow(t, contactInOrder(t, at))))
      continue;
    last = key;
    if (kept == t.freeCount || (kept >= roomOfMoving && bothMove(t, key))) {
      t.droppedCount++;
    } else {
      putKey(t.pairs, kept++, key);
    }
  }
  return kept;
}

// @ts-ignore: decorator
@inline function bothMove(t: RigidTable, key: u64): bool {
  return (flagsOf(t, firstOf(key)) & flagsOf(t, secondOf(key)) & MOVES) != 0;
}

// Whether it is a contact of the bodies to which its shapes now belong.
function isContactOfNow(t: RigidTable, contact: RigidContact): bool {
  if (!isCurrent(t, contact)) return false;
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
  contact.a = firstOf(key);
  contact.b = secondOf(key);
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

// Moves an entry of the list to another place.
// @ts-ignore: decorator
@inline export function moveEntry(t: RigidTable, from: i32, to: i32): void {
  putWord(t.order, to, word(t.order, from));
  putKey(t.keys, to, keyAt(t.keys, from));
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
