// The memory of a world's rigid bodies: a table of settings, counters and addresses (kernels/solver/2d/rigid-table.ts) and
// the lists it points to, all in the world's arena.

import { rigidKernels } from '../collision/kernels.ts';
import { bitOf } from '../components/membership.ts';
import type { Precision } from '../kernels/instantiate.ts';
import { allocate } from '../memory/arena.ts';
import { realBytes } from '../memory/columns.ts';
import {
  CONTACT_BLOCK,
  CONTACT_EVENT_LIST_BYTES,
  CROWD_BYTES,
  ContactEventListWord as EventWord,
  IMPACT_SIZE,
  REMEMBERED_BLOCK,
  RIGID_CONTACT_SIZE,
  RIGID_TABLE_BYTES,
  ROW_GROUP_BYTES,
  SLEEPER_BYTES,
  TREE_NODE_BYTES,
  TREE_ROW_BLOCK,
  RigidTableWord as Word,
} from '../memory/layouts.gen.ts';
import { allocateRecord, type MemoryRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The preset asks for the memory, so what lacks it is most often the preset. */
const NO_ROOM = 'Create the world with `preset: rigidBodies`, or, if it has that, with a larger `arenaBytes`.';

/** Contacts there is room for, by body: a pile of boxes has three each, and pairs that only come near need room too. */
const CONTACTS_PER_BODY = 6;

/** Small worlds have room for a heap. */
const MIN_CONTACTS = 4096;

/** Bytes for each contact in all lists. Contacts without a color take a block each. */
function listBytes(precision: Precision): number {
  const bytes = realBytes(precision);
  return (
    RIGID_CONTACT_SIZE[precision] +
    CONTACT_BLOCK / (16 / bytes) +
    IMPACT_SIZE[precision] / 2 +
    32 +
    56 +
    16 +
    2 * 6 * bytes
  );
}

/** The columns of reals of an event. */
const EVENT_REALS = [EventWord.x, EventWord.y, EventWord.nx, EventWord.ny, EventWord.speeds, EventWord.impulses];

/** Bytes for each row: state and pose, box, two trees of two nodes, and lists of words. */
function rowBytes(precision: Precision): number {
  const bytes = realBytes(precision);
  const trees = 4 * TREE_NODE_BYTES[precision] + TREE_ROW_BLOCK[precision] + REMEMBERED_BLOCK[precision];
  return 21 * bytes + SLEEPER_BYTES[precision] + trees + CROWD_BYTES + 18 * 4;
}

/** What rigid bodies need in the world's memory for each entity, besides what other features may: for `Preset`. */
export function rigidBytesPerEntity(precision: Precision): number {
  return Math.ceil(rowBytes(precision) + CONTACTS_PER_BODY * listBytes(precision));
}

/** Takes the memory, the first time it is asked for. @throws PhysicsError E_CAPACITY */
export const rigidTable = namedResource('rigid table', (world): MemoryRecord => {
  const table = allocateRecord(world.internal.arena, RIGID_TABLE_BYTES, 'rigid bodies');
  writeColumns(world, table.words);
  takeRows(world, table.words);
  takeContacts(world, table.words);
  rigidKernels(world).clearContacts(table.at);
  return table;
});

function writeColumns(world: PhysicsWorld, words: Uint32Array): void {
  const { Attachment, Collider, MotionLocks, Rotation } = world.addresses;
  const { force, torque } = world.scratch.at;
  words[Word.generations] = world.internal.generations.byteOffset;
  words[Word.members] = world.internal.membersAt;
  words[Word.forceX] = force.x;
  words[Word.forceY] = force.y;
  words[Word.torqueZ] = torque.z;
  words[Word.angle] = Rotation.angle;
  words[Word.tangentSpeed] = Collider.tangentSpeed;
  words[Word.rollingResistance] = Collider.rollingResistance;
  words[Word.layers] = Collider.layers;
  words[Word.masks] = Collider.mask;
  words[Word.dynamicBits] = (bitOf('Position') | bitOf('Velocity') | bitOf('Mass')) >>> 0;
  words[Word.turningBits] = (bitOf('Rotation') | bitOf('AngularVelocity')) >>> 0;
  words[Word.velocityBits] = (bitOf('Velocity') | bitOf('AngularVelocity')) >>> 0;
  words[Word.colliderBit] = bitOf('Collider');
  words[Word.sensor] = Collider.sensor;
  words[Word.bullet] = Collider.bullet;
  words[Word.oneWay] = Collider.oneWay;
  words[Word.group] = Collider.group;
  words[Word.frictionCombine] = Collider.frictionCombine;
  words[Word.restitutionCombine] = Collider.restitutionCombine;
  words[Word.segmentWallBit] = bitOf('SegmentWall');
  words[Word.planeWallBit] = bitOf('PlaneWall');
  words[Word.kinematicBit] = bitOf('Kinematic');
  words[Word.neverSleepBit] = bitOf('NeverSleep');
  words[Word.lockBit] = bitOf('MotionLocks');
  words[Word.lockX] = MotionLocks.x;
  words[Word.lockY] = MotionLocks.y;
  words[Word.lockAngle] = MotionLocks.angle;
  words[Word.attachmentBit] = bitOf('Attachment');
  words[Word.attachmentBody] = Attachment.body;
  words[Word.attachmentGeneration] = Attachment.bodyGeneration;
  words[Word.attachmentX] = Attachment.x;
  words[Word.attachmentY] = Attachment.y;
  words[Word.attachmentAngle] = Attachment.angle;
}

function takeRows(world: PhysicsWorld, words: Uint32Array): void {
  const { rows, precision, internal } = world;
  const bytes = realBytes(precision);
  const take = (word: Word, size: number) => {
    words[word] = allocate(internal.arena, size * rows, 'rigid bodies', NO_ROOM);
  };
  words[Word.rowGroups] = allocate(internal.arena, ROW_GROUP_BYTES * (rows / 16 + 1), 'rigid bodies', NO_ROOM);
  take(Word.states, 8 * bytes);
  take(Word.poses, 8 * bytes);
  take(Word.boxes, 4 * bytes);
  take(Word.fastest, bytes);
  take(Word.sleepers, SLEEPER_BYTES[precision]);
  take(Word.crowds, CROWD_BYTES);
  take(Word.staticNodes, 2 * TREE_NODE_BYTES[precision]);
  take(Word.movingNodes, 2 * TREE_NODE_BYTES[precision]);
  take(Word.ownNodes, 2 * TREE_NODE_BYTES[precision]);
  take(Word.treeRows, TREE_ROW_BLOCK[precision]);
  take(Word.rememberedColumns, REMEMBERED_BLOCK[precision]);
  for (const word of [
    Word.flags,
    Word.bodyGenerations,
    Word.filters,
    Word.usedColors,
    Word.awake,
    Word.crowded,
    Word.firstEdges,
    Word.visits,
    Word.pushes,
    Word.changedRows,
  ]) {
    take(word, 4);
  }
  for (const word of [
    Word.owners,
    Word.firstParts,
    Word.nextParts,
    Word.locked,
    Word.slept,
    Word.woken,
    Word.stops,
    Word.bullets,
    Word.wallShapes,
  ])
    take(word, 4);
}

function takeContacts(world: PhysicsWorld, words: Uint32Array): void {
  const { rows, precision, internal } = world;
  const bytes = realBytes(precision);
  const { arena } = internal;
  // Lists of 4 KiB and more start at distances that differ: 8 KiB each at most.
  const room = 0.9 * (arena.bytes - arena.top) - 45 * 8192;
  const wanted = Math.max(MIN_CONTACTS, CONTACTS_PER_BODY * rows);
  const capacity = Math.max(64, Math.floor(Math.min(wanted, room / listBytes(precision))));
  const take = (word: Word, size: number) => {
    words[word] = allocate(arena, size, 'contacts of rigid bodies', NO_ROOM);
  };
  words[Word.contactCapacity] = capacity;
  words[Word.pairCapacity] = capacity;
  words[Word.blockCapacity] = Math.ceil(capacity / (16 / bytes)) + 64;
  take(Word.contacts, RIGID_CONTACT_SIZE[precision] * capacity);
  take(Word.order, 4 * capacity);
  take(Word.keys, 8 * capacity);
  take(Word.current, 4 * capacity);
  take(Word.free, 4 * capacity);
  take(Word.newContacts, 4 * capacity);
  take(Word.touching, 8 * capacity);
  take(Word.pairs, 8 * capacity);
  take(Word.sortedPairs, 8 * capacity);
  take(Word.blocks, CONTACT_BLOCK * words[Word.blockCapacity]);
  const places = (16 / bytes) * words[Word.blockCapacity];
  words[Word.impactCapacity] = Math.ceil(places / 2);
  take(Word.impacts, IMPACT_SIZE[precision] * words[Word.impactCapacity]);
  for (const word of [Word.approaching, Word.struck]) take(word, 4 * words[Word.impactCapacity]);
  take(Word.impactOf, 4 * places);
  take(Word.nextEdges, 8 * places);
  for (const word of [Word.endA, Word.endB]) take(word, 4 * capacity);
  for (const word of [Word.sensorBeginSensors, Word.sensorBeginVisitors]) take(word, 4 * capacity);
  for (const word of [Word.sensorEndSensors, Word.sensorEndVisitors]) take(word, 4 * capacity);
  for (const word of [Word.begins, Word.hits]) words[word] = takeEvents(world, capacity);
  take(Word.colors, 4 * 32);
  take(Word.colorCounts, 4 * 32);
}

/** Makes the list of an event with room for all contacts, and returns its address. */
function takeEvents({ internal: { arena }, precision }: PhysicsWorld, capacity: number): number {
  const { at, words } = allocateRecord(arena, CONTACT_EVENT_LIST_BYTES, 'contacts of rigid bodies');
  for (const word of [EventWord.a, EventWord.b])
    words[word] = allocate(arena, 4 * capacity, 'events of contacts', NO_ROOM);
  for (const word of EVENT_REALS)
    words[word] = allocate(arena, realBytes(precision) * capacity, 'events of contacts', NO_ROOM);
  return at;
}
