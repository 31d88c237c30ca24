// The memory of a world's joints (kernels/joints/2d/joint-table.ts), and the list of joints, kept until joints or bodies
// come or go.

import { rigidKernels } from '../collision/kernels.ts';
import { bitOf } from '../components/membership.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { noId } from '../ecs/body-references.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { collectThrown } from '../errors/collect-thrown.ts';
import { allocate } from '../memory/arena.ts';
import {
  ARTICULATED_BODY_BYTES,
  ARTICULATED_MASS_BYTES,
  HINGE_START_BYTES,
  JOINT_IMPULSES_BYTES,
  JOINT_PLACE_BYTES,
  JOINT_ROW_BYTES,
  JOINT_TABLE_BYTES,
  JOINT_WORK_BYTES,
  JOINTED_BODY_BYTES,
  LOOP_BLOCK,
  LOOP_ROW_BYTES,
  MATRIX_SIZE,
  MECHANISM_BYTES,
  RigidTableWord as RigidWord,
  JointTableWord as Word,
} from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import { rigidTable } from '../solver/rigid-table.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Bytes of the rows of a joint. */
const ROWS_BYTES = 5 * JOINT_ROW_BYTES;

/** Colors of hinges that close loops, with a block each that may be nearly empty, and bytes of a hinge in a block of f64. */
const COLORS = 32;
const HINGE_BYTES = LOOP_BLOCK / 2;

/**
 * Elements of the matrices of mechanisms: a large one, and for each entity so many that each may be in a small one: a loop of
 * hinges has three joints and three bodies at least, and four elements.
 */
const MATRIX_ELEMENTS = 4;

/** What impulses do to trees: by joint, room for nine of eleven bones of a ragdoll in f64, and 20 of 48 links of a track in f32. */
const RESPONSE_BYTES = 768;

/** Memory of joints per entity, bytes: any entity may be a joint. */
export const JOINT_BYTES_PER_ENTITY =
  ARTICULATED_BODY_BYTES +
  ARTICULATED_MASS_BYTES +
  JOINTED_BODY_BYTES +
  JOINT_IMPULSES_BYTES +
  JOINT_PLACE_BYTES +
  JOINT_WORK_BYTES +
  ROWS_BYTES +
  HINGE_BYTES +
  HINGE_START_BYTES +
  MECHANISM_BYTES +
  MATRIX_ELEMENTS * 8 +
  RESPONSE_BYTES +
  6 * 8 +
  21 * 4;

/** The columns of Joint that the kernels read, in the order of the table. */
const COLUMNS = [
  ['kind', Word.kind],
  ['a', Word.a],
  ['b', Word.b],
  ['aGeneration', Word.aGeneration],
  ['bGeneration', Word.bGeneration],
  ['ax', Word.ax],
  ['ay', Word.ay],
  ['bx', Word.bx],
  ['by', Word.by],
  ['angle', Word.angle],
  ['axis', Word.axis],
  ['length', Word.length],
  ['pulleyAx', Word.pulleyAx],
  ['pulleyAy', Word.pulleyAy],
  ['pulleyBx', Word.pulleyBx],
  ['pulleyBy', Word.pulleyBy],
  ['ratio', Word.ratio],
  ['isRack', Word.isRack],
  ['hasLimits', Word.hasLimits],
  ['lower', Word.lower],
  ['upper', Word.upper],
  ['hertz', Word.hertz],
  ['dampingRatio', Word.dampingRatio],
  ['maxForce', Word.maxForce],
  ['maxCompression', Word.maxCompression],
  ['motorSpeed', Word.motorSpeed],
  ['maxMotor', Word.maxMotor],
  ['breakForce', Word.breakForce],
  ['breakTorque', Word.breakTorque],
  ['collide', Word.collide],
  ['started', Word.started],
] as const;

export interface JointTable {
  /** Its address. */
  readonly at: number;
  readonly words: Uint32Array;
  readonly entityList: EntityList;
}

/** The joints that ended by themselves, in ascending order; their entities are gone. */
export interface EndedJoints {
  /** Joints that broke in the last step. */
  readonly broken: readonly number[];
  /** Joints that went before the last step because one of their bodies was gone. */
  readonly removed: readonly number[];
}

/** `removedIn` is the step before which those of `removed` went: `world.tick` of then. */
export const endedOf = namedResource('ended joints', () => {
  return { broken: [] as number[], removed: [] as number[], removedIn: -1 };
});

/** Takes memory for each row: a joint may be any entity. @throws PhysicsError E_CAPACITY */
export const jointTable = namedResource('joint table', (world): JointTable => {
  const { arena } = world.internal;
  const { at, words } = allocateRecord(arena, JOINT_TABLE_BYTES, 'joints');
  words[Word.rigid] = rigidTable(world).at;
  words[Word.jointBit] = bitOf('Joint');
  for (const [field, word] of COLUMNS) words[word] = world.addresses.Joint[field];
  const take = (word: Word, bytes: number) => {
    words[word] = allocate(arena, bytes * world.rows, 'joints');
  };
  take(Word.impulses, JOINT_IMPULSES_BYTES);
  take(Word.bodies, ARTICULATED_BODY_BYTES);
  take(Word.jointed, JOINTED_BODY_BYTES);
  words[Word.colors] = allocate(arena, 4 * COLORS, 'joints');
  const lanes = world.precision === 'f32' ? 4 : 2;
  const blocks = Math.ceil(world.rows / lanes) + COLORS;
  words[Word.blocks] = allocate(arena, LOOP_BLOCK * blocks, 'joints');
  take(Word.masses, ARTICULATED_MASS_BYTES);
  take(Word.starts, HINGE_START_BYTES);
  take(Word.places, JOINT_PLACE_BYTES);
  take(Word.works, JOINT_WORK_BYTES);
  take(Word.rows, ROWS_BYTES);
  take(Word.mechanisms, MECHANISM_BYTES);
  take(Word.responses, RESPONSE_BYTES);
  words[Word.responseRoom] = (RESPONSE_BYTES * lanes) / 16;
  words[Word.matrixRoom] = MATRIX_SIZE * MATRIX_SIZE + MATRIX_ELEMENTS * world.rows;
  words[Word.matrices] = allocate(arena, 8 * words[Word.matrixRoom], 'joints');
  words[Word.loopRows] = allocate(arena, LOOP_ROW_BYTES * MATRIX_SIZE, 'joints');
  for (const word of [Word.pairs, Word.spare, Word.next, Word.links, Word.ends, Word.nodes]) take(word, 8);
  for (const word of [
    Word.sets,
    Word.heads,
    Word.orphans,
    Word.broken,
    Word.order,
    Word.roots,
    Word.marks,
    Word.bodyRows,
    Word.treeOf,
    Word.treeJoints,
    Word.treeStarts,
    Word.bends,
    Word.loops,
    Word.projected,
    Word.responseOf,
    Word.responsesIn,
    Word.mechanismTrees,
    Word.mechanismOf,
  ])
    take(word, 4);
  for (const word of [Word.axes, Word.active, Word.roles, Word.parents, Word.linkIds, Word.listed]) take(word, 4);
  return { at, words, entityList: emptyEntityList() };
});

/**
 * Brings the list of joints up to date. Joints of which a body was removed are removed too.
 * @throws PhysicsError E_RANGE for an end that is no id, E_CAPACITY
 */
export function refreshJoints(world: PhysicsWorld): void {
  const ended = endedOf(world);
  const { removed } = ended;
  // Nobody has heard of those that were removed before a step that was refused.
  if (removed.length > 0 && ended.removedIn !== world.tick) removed.length = 0;
  // When the last joint has gone, its bodies wake and collide again.
  const { words: rigid } = rigidTable(world);
  const hadJoints = rigid[RigidWord.jointPairCount] > 0 || rigid[RigidWord.linkCount] > 0;
  if (world.internal.counts.Joint === 0 && !hadJoints) return;
  const table = jointTable(world);
  const { words } = table;
  if (!listJoints(world, table) || words[Word.orphanCount] === 0) return;
  const ids = Array.from(new Uint32Array(world.memory.buffer, words[Word.orphans], words[Word.orphanCount]));
  removed.push(...ids);
  removed.sort((a, b) => a - b);
  ended.removedIn = world.tick;
  removeJoints(world, ids);
  listJoints(world, table);
}

function listJoints(world: PhysicsWorld, table: JointTable): boolean {
  const { entityList, words } = table;
  const isNew = refreshEntityList(world, entityList, 'Joint', 0);
  checkEnds(world, entityList);
  if (!isNew && rigidKernels(world).hasNewCollisions(table.at) === 0) return false;
  words[Word.ids] = entityList.ids;
  words[Word.count] = entityList.count;
  rigidKernels(world).listJoints(table.at);
  return true;
}

/** The kernels read the rows of the ends, which user code may have written to the columns. @throws PhysicsError E_RANGE */
function checkEnds({ memory, capacity, components: { Joint } }: PhysicsWorld, list: EntityList): void {
  const { a, b } = Joint;
  const ids = new Uint32Array(memory.buffer, list.ids, list.count);
  for (let i = 0; i < ids.length; i++) {
    const id = ids[i];
    if (a[id] <= capacity && b[id] <= capacity) continue;
    // The next step lists and checks them again.
    list.version = -1;
    throw noId(id, a[id] > capacity ? 'joint.a' : 'joint.b', Math.max(a[id], b[id]), capacity);
  }
}

function removeJoints(world: PhysicsWorld, ids: readonly number[]): void {
  for (const id of ids) {
    try {
      removeEntityCompletely(world, id);
    } catch (error) {
      collectThrown(world, error);
    }
  }
}
