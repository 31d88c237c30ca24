// The world's memory, put aside and written back. Pieces that hold only zeros are left out.
import { COLUMN_TABLE, COLUMNS_BYTES, FIRST_COLUMN } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Which parts of a memory hold anything. */
interface Layout {
  /** Pairs [from, to): the pieces, ascending. */
  readonly runs: readonly number[];
  /** The column table, and the memory of each run, to copy from. */
  readonly views: readonly Uint8Array[];
  /** Bytes of them all. */
  readonly length: number;
  /** How far the arena was used. */
  readonly top: number;
}

/** What was in a world's memory. */
export interface MemoryImage {
  layout: Layout;
  /** Bytes of the column table, then of one run behind the other. */
  bytes: Uint8Array;
  top: number;
  staggered: number;
}

const NOTHING: Layout = { runs: [], views: [], length: 0, top: 0 };

export function noImage(): MemoryImage {
  return { layout: NOTHING, bytes: new Uint8Array(0), top: 0, staggered: 0 };
}

/** Bytes of a piece: one page, which most systems hand out untouched until it is written to. */
const PIECE = 4096;

/** Copies the memory into an image, whose bytes are used again where they suffice. */
export function takeImage(world: PhysicsWorld, image: MemoryImage): void {
  const { top, staggered } = world.internal.arena;
  const layout = layoutOf(world, top);
  const { length, runs, views } = layout;
  image.layout = layout;
  if (!fits(image.bytes.length, length)) image.bytes = new Uint8Array(length + (length >> 4));
  const { bytes } = image;
  bytes.set(views[0]);
  let to = COLUMNS_BYTES;
  for (let r = 0; r < runs.length; r += 2) {
    bytes.set(views[1 + r / 2], to);
    to += runs[r + 1] - runs[r];
  }
  image.top = top;
  image.staggered = staggered;
}

/**
 * The layout of each world's last image. What once held something counts from then on, so that images that are taken
 * again and again come to a layout that stays: nothing is allocated then.
 */
const layouts = new WeakMap<PhysicsWorld, Layout>();

function layoutOf(world: PhysicsWorld, top: number): Layout {
  const last = layouts.get(world);
  // In an arena that was brought back to fewer bytes, old runs may lie beyond its end.
  const known = last === undefined || top < last.top ? NOTHING : last;
  if (known.top === top && coversAll(world, known.runs, top)) return known;
  const made = extended(world, known.runs, top);
  layouts.set(world, made);
  return made;
}

/** Whether there is nothing between the runs and behind them. */
function coversAll({ kernels }: PhysicsWorld, runs: readonly number[], top: number): boolean {
  let at = FIRST_COLUMN;
  for (let r = 0; r < runs.length; r += 2) {
    if (kernels.nextPiece(at, runs[r], PIECE, 1) < runs[r]) return false;
    at = runs[r + 1];
  }
  return at >= top || kernels.nextPiece(at, top, PIECE, 1) >= top;
}

/** The runs there were together with all that holds anything. */
function extended({ kernels, memory: { buffer } }: PhysicsWorld, before: readonly number[], top: number): Layout {
  const runs: number[] = [];
  const views = [new Uint8Array(buffer, COLUMN_TABLE, COLUMNS_BYTES)];
  let length = COLUMNS_BYTES;
  let b = 0;
  for (let at = FIRST_COLUMN; ; ) {
    const from = Math.min(kernels.nextPiece(at, top, PIECE, 1), b < before.length ? before[b] : top);
    if (from >= top) break;
    at = from;
    for (let end = -1; end !== at; ) {
      end = at;
      for (; b < before.length && before[b] <= at; b += 2) at = Math.max(at, before[b + 1]);
      if (at < top) at = kernels.nextPiece(at, top, PIECE, 0);
    }
    runs.push(from, at);
    views.push(new Uint8Array(buffer, from, at - from));
    length += at - from;
  }
  return { runs, views, length, top };
}

function fits(room: number, length: number): boolean {
  return room >= length && room <= 2 * length + PIECE;
}

/** Writes an image back: every byte is then as it was, and what was taken from the arena since is free and zero. */
export function putImage({ internal: { arena }, memory, kernels }: PhysicsWorld, image: MemoryImage): void {
  const { bytes, top, staggered } = image;
  const { runs } = image.layout;
  const target = new Uint8Array(memory.buffer);
  target.set(bytes.subarray(0, COLUMNS_BYTES), COLUMN_TABLE);
  const end = Math.max(top, arena.top);
  // Zeros are written only where there is something else, or pages never touched would become real.
  const clear = (from: number, to: number) => {
    for (let at = from; at < to; ) {
      const first = kernels.nextPiece(at, to, PIECE, 1);
      at = kernels.nextPiece(first, to, PIECE, 0);
      target.fill(0, first, at);
    }
  };
  let from = COLUMNS_BYTES;
  let at = FIRST_COLUMN;
  for (let r = 0; r < runs.length; r += 2) {
    clear(at, runs[r]);
    const length = runs[r + 1] - runs[r];
    target.set(bytes.subarray(from, from + length), runs[r]);
    from += length;
    at = runs[r + 1];
  }
  clear(at, Math.ceil(end / PIECE) * PIECE);
  arena.top = top;
  arena.staggered = staggered;
}
