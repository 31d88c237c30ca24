// The memory of a world's contacts: a table of counters and addresses (kernels/particle-contacts/table.ts) and the
// columns it points to, all in the world's arena.

import type { Precision } from '../kernels/instantiate.ts';
import { allocate } from '../memory/arena.ts';
import { writeContactTable } from '../memory/column-table.ts';
import { realBytes } from '../memory/columns.ts';
import { BODY_BYTES, CONTACT_TABLE_BYTES, ContactTableWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The contacts of a world. */
export interface ContactTable {
  /** Byte address of the table. */
  readonly table: number;
  /** Counters and column addresses, indexed by `Word`. */
  readonly words: Uint32Array;
  /** Whether the table has what touched in this step, and the bodies have been parted. */
  isResolved: boolean;
}

/** Maximum fraction of the free arena that contacts take, which leaves memory for other features. */
const MAX_ARENA_FRACTION = 0.9;

/** Contact capacity per body: a dense packing has three contacts per disc and six per ball. */
const CONTACTS_PER_BODY = { 2: 4, 3: 8 } as const;

/** In a world with spare memory contacts may use this fraction of it. */
const SPARE_FRACTION = 0.25;

/** Minimum contact capacity: a hundred bodies at one point have 4950 contacts. */
const MIN_CONTACTS = 8192;

/** Minimum wall contact capacity: in a small world most bodies may touch walls, some three of them. */
const MIN_WALL_CONTACTS = 2048;

/** Bytes per contact, summed over the columns in `allocateContacts`. */
const contactBytes = (bytes: number) => 40 + 7 * bytes + packedBytes(bytes);

/** Bytes per contact in a block of wide contacts (kernels/particle-contacts/wide-contacts.ts). */
const packedBytes = (bytes: number) => 8 * bytes;

/**
 * Bytes per wall contact, summed over the columns in `allocateWallContacts`. Large worlds have capacity for one wall
 * contact per two bodies.
 */
const wallContactBytes = (bytes: number) => 24 + 9 * bytes;

/** Arena bytes per entity that contacts need, in addition to other features; used by `Preset`. */
export function contactBytesPerEntity(dimensions: 2 | 3, precision: Precision): number {
  const bytes = realBytes(precision);
  const grid = 4 + 4 + 4 + Math.max(BODY_BYTES[precision], 16 + 4);
  const lists = CONTACTS_PER_BODY[dimensions] * contactBytes(bytes) + wallContactBytes(bytes) / 2;
  return Math.ceil((grid + lists) / MAX_ARENA_FRACTION);
}

/** Allocates the memory at the first call. @throws PhysicsError E_CAPACITY */
export const contactTable = namedResource<ContactTable>('contact table', (world) => {
  const { arena } = world.internal;
  const allocateBytes = (size: number) => allocate(arena, size, 'contacts');
  const { at, words } = allocateRecord(arena, CONTACT_TABLE_BYTES, 'contacts');
  allocateGrid(world, words, allocateBytes);
  allocateWallContacts(world, words, allocateBytes);
  allocateContacts(world, words, allocateBytes);
  allocateSorted(world, words, allocateBytes);
  const { startVelocity, stage2 } = world.scratch.at;
  words.set([startVelocity.x, startVelocity.y, startVelocity.z, stage2.x, stage2.y], Word.startX);
  return { table: at, words, isResolved: false };
});

/** Enables wall contact records and gives the kernels the address of the table. */
export function activateContacts(world: PhysicsWorld): void {
  writeContactTable(world.memory, contactTable(world).table);
  world.internal.recordsContacts = true;
}

const SORTED = [Word.sortedX, Word.sortedY, Word.sortedZ, Word.sortedRadius, Word.sortedBucket];

type AllocateBytes = (bytes: number) => number;

function allocateGrid(world: PhysicsWorld, words: Uint32Array, allocateBytes: AllocateBytes): void {
  const { rows } = world;
  let buckets = 1024;
  while (buckets < 2 * rows) buckets *= 2;
  words[Word.maxBuckets] = buckets;
  words[Word.rowWords] = allocateBytes(4 * rows);
  words[Word.bodyRows] = allocateBytes(4 * rows);
  words[Word.batches] = allocateBytes(4 * rows);
  words[Word.maxBatches] = rows;
  // The broad phase ends before the first body is gathered, so both can share memory.
  const starts = 4 * (buckets + 16);
  const region = allocateBytes(Math.max(BODY_BYTES[world.precision] * rows, starts + 4 * rows));
  words[Word.starts] = region;
  words[Word.sortedRow] = region + starts;
  words[Word.bodies] = region;
  words[Word.histogram] = allocateBytes(4 * 256);
}

/** The broad phase ends before the first contact is packed into a block, so both can share memory. */
function allocateSorted(world: PhysicsWorld, words: Uint32Array, allocateBytes: AllocateBytes): void {
  const column = sortedBytes(world) / SORTED.length;
  const region = sharesSorted(world, words[Word.capacity]) ? words[Word.blocks] : allocateBytes(SORTED.length * column);
  for (const [i, list] of SORTED.entries()) words[list] = region + i * column;
}

const sortedBytes = ({ rows, precision }: PhysicsWorld) => SORTED.length * (rows + 16) * realBytes(precision);

const sharesSorted = (world: PhysicsWorld, capacity: number) =>
  capacity * packedBytes(realBytes(world.precision)) >= sortedBytes(world);

function allocateWallContacts(world: PhysicsWorld, words: Uint32Array, allocateBytes: AllocateBytes): void {
  const capacity = Math.max(world.rows / 2, Math.min(2 * world.rows, MIN_WALL_CONTACTS));
  const bytes = realBytes(world.precision);
  words[Word.wallCapacity] = capacity;
  for (const list of [Word.wallBody, Word.wallId]) words[list] = allocateBytes(4 * capacity);
  for (const list of [
    Word.wallNx,
    Word.wallNy,
    Word.wallNz,
    Word.wallSpeed,
    Word.wallImpulse,
    Word.wallAccumulatedImpulse,
  ]) {
    words[list] = allocateBytes(bytes * capacity);
  }
  for (const list of [Word.wallGap, Word.wallFriction, Word.wallFrictionApplied])
    words[list] = allocateBytes(bytes * capacity);
  words[Word.wallTangentImpulse] = allocateBytes(12 * capacity);
  words[Word.wallSlot] = allocateBytes(4 * capacity);
}

function allocateContacts(world: PhysicsWorld, words: Uint32Array, allocateBytes: AllocateBytes): void {
  const { dimensions, rows, precision, internal } = world;
  const bytes = realBytes(precision);
  // Columns of 4 KiB and more start at staggered addresses, which costs at most 8 KiB each.
  const freeBytes = MAX_ARENA_FRACTION * (internal.arena.bytes - internal.arena.top) - 16 * 8192;
  const spare = (SPARE_FRACTION * freeBytes) / contactBytes(bytes);
  const desired = Math.max(MIN_CONTACTS, CONTACTS_PER_BODY[dimensions] * rows, spare);
  let max = Math.min(desired, freeBytes / contactBytes(bytes));
  if (!sharesSorted(world, max)) max = (freeBytes - sortedBytes(world)) / contactBytes(bytes);
  const capacity = Math.max(256, Math.floor(max / 16) * 16);
  words[Word.capacity] = capacity;
  for (const list of [Word.a, Word.b, Word.slotA, Word.slotB]) words[list] = allocateBytes(4 * capacity);
  for (const list of [Word.nx, Word.ny, Word.nz, Word.speed, Word.impulse, Word.accumulatedImpulse])
    words[list] = allocateBytes(bytes * capacity);
  words[Word.frictionState] = allocateBytes(16 * capacity);
  words[Word.blocks] = allocateBytes(packedBytes(bytes) * capacity);
  const previous = allocateBytes((8 + bytes) * capacity);
  words[Word.previousA] = previous;
  words[Word.previousB] = previous + 4 * capacity;
  words[Word.previousAccumulatedImpulse] = previous + 8 * capacity;
  words[Word.order] = words[Word.previousA];
  words[Word.flags] = words[Word.previousB];
  words[Word.gap] = words[Word.previousAccumulatedImpulse];
  // Contact points are computed when the step no longer needs these columns. In 2D z is the zero column nz.
  words[Word.x] = previous;
  words[Word.y] = previous + bytes * capacity;
  words[Word.z] = dimensions === 3 ? words[Word.frictionState] : words[Word.nz];
}
