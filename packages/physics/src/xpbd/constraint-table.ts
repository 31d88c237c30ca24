// The memory of a world's constraints (kernels/xpbd/table.ts), and when its rows are made anew. Rows keep their order while no spring and no body comes or goes; their numbers are read every step.
import { bitOf } from '../components/all.ts';
import { removeLost, scanSprings, springTable } from '../forces/support/spring-table.ts';
import { allocate } from '../memory/arena.ts';
import { realBytes } from '../memory/columns.ts';
import { CONSTRAINT_TABLE_BYTES, ConstraintTableWord as Word } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { constraintKernels } from './kernels.ts';

/** Rows that only fill up: at most three behind chains, three behind strands. */
const FILLING = 6;
/** Rows of nothing there are in strands and groups, for each spring at most. */
const SPARE = 0.5;

/** Layers of threads there are, and one more. */
const LAYERS = 16;

/** What forces and constraints can move. */
const MOVABLE = (bitOf('Position') | bitOf('Velocity') | bitOf('Mass')) >>> 0;

export interface ConstraintTable {
  /** Its address. */
  readonly at: number;
  readonly words: Uint32Array;
  /** Springs there is room for. */
  room: number;
  /** Bytes there are for solving chains and strands. */
  workRoom: number;
  /** Membership version the order of the rows belongs to. */
  version: number;
  /** Sub-step the tensions belong to, s; 0 before the first: in a cell, which snapshots copy without garbage. */
  readonly substep: Float64Array;
}

/** @throws PhysicsError E_CAPACITY */
export const constraintTable = resource((world): ConstraintTable => {
  const { arena } = world.internal;
  const { at, words } = allocateRecord(arena, CONSTRAINT_TABLE_BYTES, 'constraints');
  const table = { at, words, room: 0, workRoom: 0, version: -1, substep: new Float64Array(1) };
  const { rows } = world;
  const real = realBytes(world.precision);
  const take = (word: Word, bytes: number) => {
    words[word] = allocate(arena, bytes, 'constraints');
  };
  words[Word.springs] = springTable(world).at;
  words[Word.breakForce] = world.addresses.Spring.breakForce;
  take(Word.nodes, 4 * rows);
  take(Word.packed, 4 * real * rows);
  take(Word.inverse, real * rows);
  take(Word.masks, 8 * rows);
  take(Word.degree, 4 * rows);
  take(Word.joined, 8 * rows);
  take(Word.open, 4 * 64);
  take(Word.sum, 64);
  take(Word.layers, (4 + 4 + real) * LAYERS);
  return table;
});

/**
 * Brings the rows up to date, for sub-steps of `h` seconds. Springs that lost an end are removed.
 * @throws PhysicsError E_CAPACITY
 */
export function refreshConstraints(world: PhysicsWorld, h: number): ConstraintTable {
  const table = constraintTable(world);
  const kernels = constraintKernels(world);
  const springs = springTable(world);
  if (springs.removed.length > 0) springs.removed = [];
  if (table.version === world.versions.membership && kernels.readConstraints(table.at, MOVABLE, h) === 1) return table;
  removeLost(world, scanSprings(world));
  makeRows(world, table);
  makeWork(world, table, kernels.arrangeConstraints(table.at, MOVABLE, world.lastId));
  kernels.readConstraints(table.at, MOVABLE, h);
  table.version = world.versions.membership;
  table.substep[0] = 0;
  return table;
}

/** Room for as many rows as there are springs, and for the list of those that broke. @throws PhysicsError E_CAPACITY */
export function makeRows(world: PhysicsWorld, table: ConstraintTable): void {
  const { arena, counts } = world.internal;
  if (counts.Spring <= table.room) return;
  const room = Math.min(world.rows, Math.max(64, Math.ceil(1.5 * counts.Spring)));
  const rows = Math.ceil(room * (1 + SPARE)) + FILLING;
  const real = realBytes(world.precision);
  const take = (word: Word, bytes: number) => {
    table.words[word] = allocate(arena, bytes, `${counts.Spring} springs as constraints`);
  };
  for (const word of [Word.state, Word.source, Word.a, Word.b, Word.chains, Word.strands, Word.broken])
    take(word, 4 * (rows + 1));
  for (const word of [Word.length, Word.gain, Word.softness, Word.tension]) take(word, real * rows);
  table.room = room;
}

/** What is kept of a body of a chain (kernels/xpbd/taut-chain.ts), and of one of each thread of a strand. */
const CHAIN_BYTES = 232;
const STRAND_BYTES = 192;

/** Room to solve chains of so many rows in all, or the longest strand. @throws PhysicsError E_CAPACITY */
function makeWork(world: PhysicsWorld, table: ConstraintTable, chained: number): void {
  const longest = table.words[Word.longest];
  const bytes = Math.max(chained && CHAIN_BYTES * (chained + 1), longest && STRAND_BYTES * (longest + 2));
  if (bytes <= table.workRoom) return;
  const room = Math.ceil(1.5 * bytes);
  table.words[Word.work] = allocate(world.internal.arena, room, `${Math.max(chained, longest)} springs in a row`);
  table.workRoom = room;
}
