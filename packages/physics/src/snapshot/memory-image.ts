// Saves and restores the world's memory. Pages that contain only zeros are omitted.
import { clearMemory, PAGE_BYTES, seekPage } from '../memory/arena.ts';
import { COLUMN_TABLE, COLUMNS_BYTES, FIRST_COLUMN } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The non-zero ranges of a memory. */
interface Layout {
  /** The ranges as pairs [from, to), ascending. */
  readonly runs: readonly number[];
  /** Views of the column table and of each range. */
  readonly views: readonly Uint8Array[];
  /** Total bytes of the views. */
  readonly length: number;
  /** Bytes of the arena in use. */
  readonly top: number;
}

/** A saved copy of a world's memory. */
export interface MemoryImage {
  layout: Layout;
  /** Bytes of the column table, followed by those of the ranges. */
  bytes: Uint8Array;
  top: number;
  staggered: number;
}

const EMPTY_LAYOUT: Layout = { runs: [], views: [], length: 0, top: 0 };

export function noImage(): MemoryImage {
  return { layout: EMPTY_LAYOUT, bytes: new Uint8Array(0), top: 0, staggered: 0 };
}

/** Copies the memory into an image and reuses its buffer if it is large enough. */
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
 * The layout of each world's last image. A range that was non-zero once stays in the layout, so that repeated images
 * reach a stable layout and allocate nothing.
 */
const layouts = new WeakMap<PhysicsWorld, Layout>();

function layoutOf(world: PhysicsWorld, top: number): Layout {
  const last = layouts.get(world);
  // After a restore to a smaller arena, old ranges may lie beyond its end.
  const previous = last === undefined || top < last.top ? EMPTY_LAYOUT : last;
  if (previous.top === top && coversAll(world, previous.runs, top)) return previous;
  const made = extendRanges(world, previous.runs, top);
  layouts.set(world, made);
  return made;
}

/** Returns whether the memory between and after the ranges is zero. */
function coversAll({ kernels }: PhysicsWorld, runs: readonly number[], top: number): boolean {
  let at = FIRST_COLUMN;
  for (let r = 0; r < runs.length; r += 2) {
    if (seekPage(kernels.findPage, at, runs[r], 'used') < runs[r]) return false;
    at = runs[r + 1];
  }
  return at >= top || seekPage(kernels.findPage, at, top, 'used') >= top;
}

/** Returns the given ranges extended by all non-zero pages. */
function extendRanges({ kernels, memory: { buffer } }: PhysicsWorld, before: readonly number[], top: number): Layout {
  const runs: number[] = [];
  const views = [new Uint8Array(buffer, COLUMN_TABLE, COLUMNS_BYTES)];
  let length = COLUMNS_BYTES;
  let b = 0;
  for (let at = FIRST_COLUMN; ; ) {
    const from = Math.min(seekPage(kernels.findPage, at, top, 'used'), b < before.length ? before[b] : top);
    if (from >= top) break;
    at = from;
    for (let end = -1; end !== at; ) {
      end = at;
      for (; b < before.length && before[b] <= at; b += 2) at = Math.max(at, before[b + 1]);
      if (at < top) at = seekPage(kernels.findPage, at, top, 'zero');
    }
    runs.push(from, at);
    views.push(new Uint8Array(buffer, from, at - from));
    length += at - from;
  }
  return { runs, views, length, top };
}

function fits(capacity: number, length: number): boolean {
  return capacity >= length && capacity <= 2 * length + PAGE_BYTES;
}

/** Restores an image: every byte has its saved value, and memory allocated since is free and zero. */
export function putImage({ internal: { arena }, memory, kernels }: PhysicsWorld, image: MemoryImage): void {
  const { bytes, top, staggered } = image;
  const { runs } = image.layout;
  const target = new Uint8Array(memory.buffer);
  target.set(bytes.subarray(0, COLUMNS_BYTES), COLUMN_TABLE);
  const end = Math.max(top, arena.top);
  const clear = (from: number, to: number) => clearMemory(memory, kernels.findPage, from, to);
  let from = COLUMNS_BYTES;
  let at = FIRST_COLUMN;
  for (let r = 0; r < runs.length; r += 2) {
    clear(at, runs[r]);
    const length = runs[r + 1] - runs[r];
    target.set(bytes.subarray(from, from + length), runs[r]);
    from += length;
    at = runs[r + 1];
  }
  clear(at, Math.ceil(end / PAGE_BYTES) * PAGE_BYTES);
  arena.top = top;
  arena.kept = Math.min(arena.kept, top);
  arena.staggered = staggered;
}
