// The memory of a world's contacts: a table of counters and addresses (kernels/particle-contacts/table.ts) and the
// lists it points to, all in the world's arena.

import type { Precision } from '../kernels/instantiate.ts';
import { allocate } from '../memory/arena.ts';
import { writeContactTable } from '../memory/column-table.ts';
import { realBytes } from '../memory/columns.ts';
import { BODY_BYTES, CONTACT_TABLE_BYTES, ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A world's contacts as the systems of this package see them. */
export interface ContactTable {
  /** Its address. */
  readonly table: number;
  /** Counters and addresses of lists, by `Word`. */
  readonly words: Uint32Array;
}

/** Of what the arena has left, contacts take at most this part: other features may come later. */
const SHARE = 0.9;

/** Contacts there is room for, by bodies and dimensions: a dense packing has three a disc and six a ball. */
const CONTACTS_A_BODY = { 2: 4, 3: 8 } as const;

/** A world with memory to spare has room for more: contacts may take this part of what is left. */
const SPARE = 0.25;

/** Small worlds have room for a heap: a hundred bodies in one place are 4950 contacts. */
const MIN_CONTACTS = 8192;

/** In a small world most bodies may lie at walls, some at three. */
const MIN_WALL_CONTACTS = 2048;

/** Bytes of a contact: its lists in `takeContacts`. */
const contactBytes = (bytes: number) => 40 + 6 * bytes + packedBytes(bytes);

/** Bytes of a contact in a block of those that are solved side by side (kernels/particle-contacts/wide-contacts.ts). */
const packedBytes = (bytes: number) => 8 * bytes;

/** Bytes of a contact with a wall: its lists in `takeWallContacts`. Large worlds have room for one every other body. */
const wallContactBytes = (bytes: number) => 24 + 8 * bytes;

/** What contacts need in the world's memory for each entity, besides what other features may: for `Preset`. */
export function contactBytesPerEntity(dimensions: 2 | 3, precision: Precision): number {
  const bytes = realBytes(precision);
  const grid = 4 + 4 + 4 + Math.max(BODY_BYTES[precision], 16 + 4);
  const lists = CONTACTS_A_BODY[dimensions] * contactBytes(bytes) + wallContactBytes(bytes) / 2;
  return Math.ceil((grid + lists) / SHARE);
}

/** Takes the memory, the first time it is asked for. @throws PhysicsError E_CAPACITY */
export const contactTable = resource<ContactTable>((world) => {
  const { arena } = world.internal;
  const take = (size: number) => allocate(arena, size, 'contacts');
  const { at, words } = allocateRecord(arena, CONTACT_TABLE_BYTES, 'contacts');
  takeGrid(world, words, take);
  takeWallContacts(world, words, take);
  takeContacts(world, words, take);
  takeSorted(world, words, take);
  const { startVelocity, stage2 } = world.scratch.at;
  words.set([startVelocity.x, startVelocity.y, startVelocity.z, stage2.x, stage2.y], Word.startX);
  return { table: at, words };
});

/** From now on walls write their contacts down, and the kernels find the table. */
export function activateContacts(world: PhysicsWorld): void {
  writeContactTable(world.memory, contactTable(world).table);
}

const SORTED = [Word.sortedX, Word.sortedY, Word.sortedZ, Word.sortedRadius, Word.sortedBucket];

type Take = (bytes: number) => number;

function takeGrid(world: PhysicsWorld, words: Uint32Array, take: Take): void {
  const { rows } = world;
  let buckets = 1024;
  while (buckets < 2 * rows) buckets *= 2;
  words[Word.maxBuckets] = buckets;
  words[Word.rowWords] = take(4 * rows);
  words[Word.bodyRows] = take(4 * rows);
  words[Word.levels] = take(4 * rows);
  words[Word.mostLevels] = rows;
  // The broad phase is over before the first body is gathered, so that the two can share their memory.
  const starts = 4 * (buckets + 16);
  const region = take(Math.max(BODY_BYTES[world.precision] * rows, starts + 4 * rows));
  words[Word.starts] = region;
  words[Word.sortedRow] = region + starts;
  words[Word.bodies] = region;
  words[Word.histogram] = take(4 * 256);
}

/** Likewise, it is over before the first contact is packed into a block. */
function takeSorted(world: PhysicsWorld, words: Uint32Array, take: Take): void {
  const column = sortedBytes(world) / SORTED.length;
  const region = sharesSorted(world, words[Word.capacity]) ? words[Word.blocks] : take(SORTED.length * column);
  for (const [i, list] of SORTED.entries()) words[list] = region + i * column;
}

const sortedBytes = ({ rows, precision }: PhysicsWorld) => SORTED.length * (rows + 16) * realBytes(precision);

const sharesSorted = (world: PhysicsWorld, capacity: number) =>
  capacity * packedBytes(realBytes(world.precision)) >= sortedBytes(world);

function takeWallContacts(world: PhysicsWorld, words: Uint32Array, take: Take): void {
  const capacity = Math.max(world.rows / 2, Math.min(2 * world.rows, MIN_WALL_CONTACTS));
  const bytes = realBytes(world.precision);
  words[Word.wallCapacity] = capacity;
  for (const list of [Word.wallBody, Word.wallId]) words[list] = take(4 * capacity);
  for (const list of [Word.wallNx, Word.wallNy, Word.wallNz, Word.wallImpulse, Word.wallHolding]) {
    words[list] = take(bytes * capacity);
  }
  for (const list of [Word.wallGap, Word.wallFriction, Word.wallRubbed]) words[list] = take(bytes * capacity);
  words[Word.wallRubbing] = take(12 * capacity);
  words[Word.wallSlot] = take(4 * capacity);
}

function takeContacts(world: PhysicsWorld, words: Uint32Array, take: Take): void {
  const { dimensions, rows, precision, internal } = world;
  const bytes = realBytes(precision);
  // Lists of 4 KiB and more start at distances that differ: 8 KiB each at most.
  const room = SHARE * (internal.arena.bytes - internal.arena.top) - 16 * 8192;
  const spare = (SPARE * room) / contactBytes(bytes);
  const wanted = Math.max(MIN_CONTACTS, CONTACTS_A_BODY[dimensions] * rows, spare);
  let most = Math.min(wanted, room / contactBytes(bytes));
  if (!sharesSorted(world, most)) most = (room - sortedBytes(world)) / contactBytes(bytes);
  const capacity = Math.max(256, Math.floor(most / 16) * 16);
  words[Word.capacity] = capacity;
  for (const list of [Word.a, Word.b, Word.slotA, Word.slotB]) words[list] = take(4 * capacity);
  for (const list of [Word.nx, Word.ny, Word.nz, Word.impulse, Word.holding]) words[list] = take(bytes * capacity);
  words[Word.rubbing] = take(16 * capacity);
  words[Word.blocks] = take(packedBytes(bytes) * capacity);
  const previous = take((8 + bytes) * capacity);
  words[Word.previousA] = previous;
  words[Word.previousB] = previous + 4 * capacity;
  words[Word.previousHolding] = previous + 8 * capacity;
  words[Word.order] = words[Word.previousA];
  words[Word.flags] = words[Word.previousB];
  words[Word.gap] = words[Word.previousHolding];
  // Points are worked out when the step has no more use for these lists. In 2D z is zero, as nz is.
  words[Word.x] = previous;
  words[Word.y] = previous + bytes * capacity;
  words[Word.z] = dimensions === 3 ? words[Word.rubbing] : words[Word.nz];
}
