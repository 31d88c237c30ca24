// The record of a world's constraints (kernels/xpbd/table.ts). Its rows are assigned anew when springs or bodies are
// added or removed; their coefficients are read every step.
import { bitOf } from '../components/membership.ts';
import { removeDanglingSprings, scanSprings, springTable } from '../forces/support/spring-table.ts';
import { allocate, allocateTogether } from '../memory/arena.ts';
import { realBytes } from '../memory/columns.ts';
import { CONSTRAINT_TABLE_BYTES, ConstraintTableWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { constraintKernels } from './kernels.ts';

/** Padding rows: at most three after the chains and three after the batches of polylines. */
const PADDING_ROWS = 6;
/** Padding rows in batches and groups, at most, per spring, and if there are few springs (kernels/xpbd/polylines.ts). */
const MAX_PADDING_PER_SPRING = 0.5;
const MAX_SMALL_PADDING = 4096;

/** The maximum number of passes of polylines, plus one. */
const PASSES = 16;

/** The membership bits of a body that forces and constraints can move. */
const MOVABLE = (bitOf('Position') | bitOf('Velocity') | bitOf('Mass')) >>> 0;

export interface ConstraintTable {
  /** The address of the record. */
  readonly at: number;
  readonly words: Uint32Array;
  /** The number of springs that the rows have capacity for. */
  capacity: number;
  /** The size of the scratch memory for chains and batches, bytes. */
  scratchBytes: number;
  /** The membership version of the current row order. */
  version: number;
  /**
   * The sub-step of the stored tensions, s; 0 before the first. It is in a typed array, which snapshots copy without
   * garbage.
   */
  readonly substep: Float64Array;
}

/** @throws PhysicsError E_CAPACITY */
export const constraintTable = namedResource('constraint table', (world): ConstraintTable => {
  const { arena } = world.internal;
  const { at, words } = allocateRecord(arena, CONSTRAINT_TABLE_BYTES, 'constraints');
  const table = { at, words, capacity: 0, scratchBytes: 0, version: -1, substep: new Float64Array(1) };
  const { rows } = world;
  const real = realBytes(world.precision);
  const allocateColumn = (word: Word, bytes: number) => {
    words[word] = allocate(arena, bytes, 'constraints');
  };
  words[Word.springs] = springTable(world).at;
  words[Word.breakForce] = world.addresses.Spring.breakForce;
  allocateColumn(Word.nodes, 4 * rows);
  allocateColumn(Word.packed, 4 * real * rows);
  allocateColumn(Word.inverseMass, real * rows);
  allocateColumn(Word.groupMasks, 8 * rows);
  allocateColumn(Word.degree, 4 * rows);
  allocateColumn(Word.joined, 8 * rows);
  allocateColumn(Word.openGroups, 4 * 64);
  allocateColumn(Word.checksum, 64);
  allocateColumn(Word.passes, (4 + 4 + real) * PASSES);
  return table;
});

/**
 * Updates the rows for sub-steps of `h` seconds, and removes springs that lost an end.
 * @throws PhysicsError E_CAPACITY
 */
export function refreshConstraints(world: PhysicsWorld, h: number): ConstraintTable {
  const table = constraintTable(world);
  const kernels = constraintKernels(world);
  if (table.version === world.versions.membership && kernels.readConstraints(table.at, MOVABLE, h) === 1) return table;
  removeDanglingSprings(world, scanSprings(world));
  arrange(world, table, h);
  table.version = world.versions.membership;
  return table;
}

/**
 * The table at the start of a step, after the forces were prepared: one of them may have removed bodies. Springs that lost an end pull
 * no more, and the next `refreshConstraints` removes them.
 * @throws PhysicsError E_CAPACITY
 */
export function currentConstraints(world: PhysicsWorld, h: number): ConstraintTable {
  const table = constraintTable(world);
  if (table.version === world.versions.membership) return table;
  scanSprings(world);
  arrange(world, table, h);
  table.version = -1;
  return table;
}

/** Assigns the rows of all springs that were listed. @throws PhysicsError E_CAPACITY */
function arrange(world: PhysicsWorld, table: ConstraintTable, h: number): void {
  const kernels = constraintKernels(world);
  allocateRows(world, table);
  allocateScratch(world, table, kernels.arrangeConstraints(table.at, MOVABLE, world.lastId));
  kernels.readConstraints(table.at, MOVABLE, h);
  table.substep[0] = 0;
}

/** Allocates rows for all springs, and the list of broken springs. @throws PhysicsError E_CAPACITY */
export function allocateRows(world: PhysicsWorld, table: ConstraintTable): void {
  const { arena, counts } = world.internal;
  if (counts.Spring <= table.capacity) return;
  const capacity = Math.min(world.rows, Math.max(64, Math.ceil(1.5 * counts.Spring)));
  const padding = Math.max(MAX_PADDING_PER_SPRING * capacity, Math.min(3 * capacity, MAX_SMALL_PADDING));
  const rows = Math.ceil(capacity + padding) + PADDING_ROWS;
  const real = realBytes(world.precision);
  const allocateColumn = (bytes: number) => (word: Word) =>
    [word, allocate(arena, bytes, `${counts.Spring} springs as constraints`)] as const;
  const ids = [Word.assigned, Word.springIds, Word.a, Word.b, Word.chains, Word.batches, Word.broken];
  const reals = [Word.length, Word.gain, Word.softness, Word.tension];
  const columns = allocateTogether(arena, world.kernels.findPage, () => [
    ...ids.map(allocateColumn(4 * (rows + 1))),
    ...reals.map(allocateColumn(real * rows)),
  ]);
  for (const [word, at] of columns) table.words[word] = at;
  table.capacity = capacity;
}

/** Scratch bytes per body of a chain (kernels/xpbd/dual-chain.ts), and per node of a batch of polylines. */
const CHAIN_BYTES = 376;
const BATCH_BYTES = 192;

/** Allocates scratch memory for `chained` rows of chains, or for the longest batch. @throws PhysicsError E_CAPACITY */
function allocateScratch(world: PhysicsWorld, table: ConstraintTable, chained: number): void {
  const longest = table.words[Word.longestPolyline];
  const bytes = Math.max(chained && CHAIN_BYTES * (chained + 1), longest && BATCH_BYTES * (longest + 2));
  if (bytes <= table.scratchBytes) return;
  const size = Math.ceil(1.5 * bytes);
  table.words[Word.scratch] = allocate(world.internal.arena, size, `${Math.max(chained, longest)} springs in a chain`);
  table.scratchBytes = size;
}
