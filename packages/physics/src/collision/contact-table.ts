// The memory of a world's contacts: a table of counters and addresses that kernels/collision/table.ts lays out, and
// the lists it points to, all in the world's arena.
import { allocate } from '../store/arena';
import { TABLE_ADDRESS, TABLE_COLUMNS } from '../store/column-table';
import { realBytes } from '../store/columns';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';

/** The words of the table after its first field, the f64 `previousDt`; in the order of the kernels' class. */
export const TABLE_WORDS = [
  'capacity',
  'count',
  'lost',
  'a',
  'b',
  'nx',
  'ny',
  'nz',
  'impulse',
  'holding',
  'rubbing',
  'x',
  'y',
  'z',
  'rawA',
  'rawB',
  'previousCount',
  'previousA',
  'previousB',
  'previousHolding',
  'wallCapacity',
  'wallCount',
  'wallLost',
  'wallBody',
  'wallId',
  'wallNx',
  'wallNy',
  'wallNz',
  'wallImpulse',
  'wallHolding',
  'wallGap',
  'wallFriction',
  'wallRubbed',
  'wallRubbing',
  'rowWords',
  'starts',
  'packed',
  'maxBuckets',
  'buckets',
  'stride',
  'layer',
  'gridCount',
  'largeCount',
  'large',
  'histogram',
  'startX',
  'startY',
  'startZ',
  'pushX',
  'pushY',
  'pushZ',
  'fromX',
  'fromY',
  'fromZ',
] as const;

type Word = (typeof TABLE_WORDS)[number];

/** A world's contacts as the systems of this package see them. */
export interface ContactTable {
  /** Its address. */
  readonly table: number;
  /** Reads a counter of the table. */
  read(word: Word): number;
  /** Address of a list. */
  readonly at: Readonly<Record<Word, number>>;
}

/** Of what the arena has left, contacts take this part: other features may come later. */
const SHARE = 0.8;

/** Contacts a body may be expected to have at most, on average: a dense packing of balls has six. */
const CONTACTS_A_BODY = 8;

/** Takes the memory, the first time it is asked for. @throws PhysicsError E_CAPACITY */
export const contactTable = resource<ContactTable>((world) => {
  const { arena } = world.internal;
  const bytes = realBytes(world.precision);
  const take = (size: number) => allocate(arena, size, 'contacts');
  const words: Record<Word, number> = Object.fromEntries(TABLE_WORDS.map((name) => [name, 0])) as Record<Word, number>;
  const table = take(8 + 4 * TABLE_WORDS.length);
  takeGrid(world, words, take);
  takeWallContacts(world, words, take);
  takeContacts(words, take, bytes, world.dimensions, world.rows, SHARE * (arena.bytes - arena.top));
  for (const axis of ['x', 'y', 'z'] as const) {
    const { startVelocity, stage1, stage2 } = world.scratch.at;
    const upper = axis.toUpperCase() as 'X' | 'Y' | 'Z';
    words[`start${upper}`] = startVelocity[axis];
    words[`push${upper}`] = stage1[axis];
    words[`from${upper}`] = stage2[axis];
  }
  const view = new Uint32Array(world.memory.buffer, table + 8, TABLE_WORDS.length);
  for (let w = 0; w < TABLE_WORDS.length; w++) view[w] = words[TABLE_WORDS[w]];
  return { table, at: words, read: (word) => view[TABLE_WORDS.indexOf(word)] };
});

/** From now on walls write their contacts down, and the kernels find the table. */
export function useContacts(world: PhysicsWorld): void {
  const pointer = TABLE_ADDRESS / 4 + TABLE_COLUMNS.indexOf('contacts');
  new Uint32Array(world.memory.buffer)[pointer] = contactTable(world).table;
}

type Take = (bytes: number) => number;

function takeGrid(world: PhysicsWorld, words: Record<Word, number>, take: Take): void {
  const { rows, dimensions } = world;
  let buckets = 1024;
  while (buckets < 2 * rows) buckets *= 2;
  words.maxBuckets = buckets;
  words.rowWords = take(4 * rows);
  words.starts = take(4 * (buckets + 2));
  words.packed = take((dimensions + 2) * realBytes(world.precision) * rows);
  words.large = take(4 * 16);
  words.histogram = take(4 * 256);
}

function takeWallContacts(world: PhysicsWorld, words: Record<Word, number>, take: Take): void {
  const capacity = world.rows / 2;
  const bytes = realBytes(world.precision);
  words.wallCapacity = capacity;
  for (const name of ['wallBody', 'wallId'] as const) words[name] = take(4 * capacity);
  for (const name of ['wallNx', 'wallNy', 'wallNz', 'wallImpulse', 'wallHolding'] as const) {
    words[name] = take(bytes * capacity);
  }
  for (const name of ['wallGap', 'wallFriction', 'wallRubbed'] as const) words[name] = take(bytes * capacity);
  words.wallRubbing = take(12 * capacity);
}

function takeContacts(
  words: Record<Word, number>,
  take: Take,
  bytes: number,
  dimensions: 2 | 3,
  rows: number,
  room: number,
): void {
  const each = 36 + 6 * bytes;
  const most = Math.min(CONTACTS_A_BODY * rows, Math.floor((room - 65536) / each));
  const capacity = Math.max(256, Math.floor(most / 16) * 16);
  words.capacity = capacity;
  for (const name of ['a', 'b'] as const) words[name] = take(4 * capacity);
  for (const name of ['nx', 'ny', 'nz', 'impulse', 'holding'] as const) words[name] = take(bytes * capacity);
  words.rubbing = take(12 * capacity);
  const raw = take(8 * capacity);
  words.rawA = raw;
  words.rawB = raw + 4 * capacity;
  const previous = take((8 + bytes) * capacity);
  words.previousA = previous;
  words.previousB = previous + 4 * capacity;
  words.previousHolding = previous + 8 * capacity;
  // Points are worked out when the step has no more use for these lists. In 2D z is zero, as nz is.
  words.x = previous;
  words.y = previous + bytes * capacity;
  words.z = dimensions === 3 ? raw : words.nz;
}
