// The world's memory, put aside and written back. Pieces that hold only zeros are left out.
import { RESERVED_BYTES, TABLE_ADDRESS, TABLE_COLUMNS } from '../store/column-table';
import type { PhysicsWorld } from '../world';

/** What was in a world's memory. */
export interface MemoryImage {
  /** Pairs [from, to): the pieces that held anything, ascending. */
  readonly runs: readonly number[];
  /** Their bytes, one run behind the other, behind the bytes of the column table. */
  readonly bytes: Uint8Array;
  readonly length: number;
  /** How far the arena was used. */
  readonly top: number;
  readonly staggered: number;
}

/** Bytes of a piece: one page, which most systems hand out untouched until it is written to. */
const PIECE = 4096;

const TABLE_BYTES = 4 * TABLE_COLUMNS.length;

/** Copies the memory. @param spare an image nobody needs any more: its bytes are used again where they suffice */
export function takeImage({ internal: { arena }, memory, kernels }: PhysicsWorld, spare?: MemoryImage): MemoryImage {
  const { top, staggered } = arena;
  const runs: number[] = [];
  let length = TABLE_BYTES;
  for (let at = RESERVED_BYTES; at < top; ) {
    const from = kernels.nextPiece(at, top, PIECE, 1);
    if (from >= top) break;
    at = kernels.nextPiece(from, top, PIECE, 0);
    runs.push(from, at);
    length += at - from;
  }
  const bytes = spare !== undefined && fits(spare.bytes.length, length) ? spare.bytes : new Uint8Array(length);
  const source = new Uint8Array(memory.buffer);
  bytes.set(source.subarray(TABLE_ADDRESS, TABLE_ADDRESS + TABLE_BYTES));
  let to = TABLE_BYTES;
  for (let r = 0; r < runs.length; r += 2) {
    bytes.set(source.subarray(runs[r], runs[r + 1]), to);
    to += runs[r + 1] - runs[r];
  }
  return { runs, bytes, length, top, staggered };
}

function fits(room: number, length: number): boolean {
  return room >= length && room <= 2 * length + PIECE;
}

/** Writes an image back: every byte is then as it was, and what was taken from the arena since is free and zero. */
export function putImage({ internal: { arena }, memory, kernels }: PhysicsWorld, image: MemoryImage): void {
  const { runs, bytes, top, staggered } = image;
  const target = new Uint8Array(memory.buffer);
  target.set(bytes.subarray(0, TABLE_BYTES), TABLE_ADDRESS);
  const end = Math.max(top, arena.top);
  // Zeros are written only where there is something else, or pages never touched would become real.
  const clear = (from: number, to: number) => {
    for (let at = from; at < to; ) {
      const first = kernels.nextPiece(at, to, PIECE, 1);
      at = kernels.nextPiece(first, to, PIECE, 0);
      target.fill(0, first, at);
    }
  };
  let from = TABLE_BYTES;
  let at = RESERVED_BYTES;
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
