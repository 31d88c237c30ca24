import { PhysicsError } from '../errors/physics-error.ts';

const PAGE = 65536;
/** Pages of 32-bit addresses. */
const MAX_PAGES = 65536;

/**
 * The world's block of memory with a bump allocator. Memory is never freed: a world or feature allocates at creation,
 * and pages are not touched until used.
 */
export interface Arena {
  readonly memory: WebAssembly.Memory;
  readonly bytes: number;
  /** The part that was asked for as `arenaBytes`, or by default: the rest is columns. */
  readonly arenaBytes: number;
  top: number;
  /** The memory below this address belongs to features that were made to the end. */
  kept: number;
  staggered: number;
}

/**
 * Creates a fixed block of at least `bytes`, `arenaBytes` of which are for features.
 * @throws PhysicsError E_CAPACITY if the machine or the 4 GiB address space cannot hold it
 */
export function createArena(bytes: number, reserved: number, arenaBytes: number): Arena {
  const pages = Math.ceil(bytes / PAGE);
  let memory: WebAssembly.Memory;
  try {
    memory = new WebAssembly.Memory({ initial: pages, maximum: pages });
    if (memory.buffer.byteLength < pages * PAGE) throw new RangeError('the memory is smaller than requested');
  } catch (cause) {
    const error = new PhysicsError('E_CAPACITY', `cannot allocate ${(bytes / 2 ** 20).toFixed(0)} MiB of memory.`, {
      field: 'capacity',
      hint:
        pages > MAX_PAGES
          ? 'A world can have at most 4096 MiB: lower `capacity`, or use precision "f32".'
          : 'The machine has no more: lower `capacity`, use precision "f32", or destroy worlds that are no longer needed, and drop their columns.',
    });
    error.cause = cause;
    throw error;
  }
  return { memory, bytes: pages * PAGE, arenaBytes, top: reserved, kept: reserved, staggered: 0 };
}

/**
 * Allocates `bytes` zero bytes, 64-byte aligned, and returns their address. The addresses of columns differ modulo
 * 4096, so that loops over a dozen columns do not compete for the same cache sets.
 * @param hint what to do where there is no room
 * @throws PhysicsError E_CAPACITY if the arena is full
 */
export function allocate(arena: Arena, bytes: number, what: string, hint?: string): number {
  const STAGGER = 320;
  const aligned = Math.ceil(arena.top / 4096) * 4096;
  const address = bytes >= 4096 ? aligned + ((arena.staggered++ * STAGGER) % 4096) : Math.ceil(arena.top / 64) * 64;
  if (address + bytes > arena.bytes) throw noRoom(arena, address + bytes, bytes, what, hint);
  arena.top = address + bytes;
  return address;
}

/**
 * Finds out whether there is room for `count` blocks, so that the message names the memory that all of them need.
 * @throws PhysicsError E_CAPACITY if there is not
 */
export function checkRoom(arena: Arena, count: number, bytes: number, what: string): void {
  const trial = { ...arena, bytes: Number.POSITIVE_INFINITY };
  for (let i = 0; i < count; i++) allocate(trial, bytes, what);
  if (trial.top > arena.bytes) throw noRoom(arena, trial.top, trial.top - arena.top, what);
}

/** Contacts take a quarter of the memory that is left, so more than what is missing is needed. */
const SHARE_LEFT = 0.75;

function noRoom(arena: Arena, end: number, bytes: number, what: string, hint?: string): PhysicsError {
  const MEBIBYTE = 2 ** 20;
  const { arenaBytes } = arena;
  const enough = Math.ceil((arenaBytes + (end - arena.bytes) / SHARE_LEFT) / MEBIBYTE) * MEBIBYTE;
  return new PhysicsError('E_CAPACITY', `the arena of the world has no room for ${what} (${bytes} bytes).`, {
    field: 'arenaBytes',
    hint: hint ?? `Create the world with \`arenaBytes: ${enough}\` or more; it has ${arenaBytes}.`,
  });
}

/**
 * Calls `make`, and if it throws, gives back the memory that it allocated, all zero again. Memory of features that were
 * made to the end meanwhile stays.
 * @param findPage finds pages in use, because writing zeros would commit untouched ones
 */
export function allocateTogether<T>(arena: Arena, findPage: FindPage, make: () => T): T {
  const { top, staggered } = arena;
  try {
    const made = make();
    if (arena.top !== top) arena.kept = arena.top;
    return made;
  } catch (error) {
    const end = arena.top;
    arena.top = Math.max(top, arena.kept);
    if (arena.top === top) arena.staggered = staggered;
    clearMemory(arena.memory, findPage, arena.top, end);
    throw error;
  }
}

/** `findPage` of the kernels, for {@link seekPage}. */
export type FindPage = (from: number, to: number, bytes: number, used: number) => number;

/** Granularity in bytes: one page, which most systems allocate only when it is first written. */
export const PAGE_BYTES = 4096;

/** An address or a size that a kernel returned: WebAssembly hands it over as a signed number, negative from 2 GiB on. */
export function unsigned(result: number): number {
  return result >>> 0;
}

/** Returns the address of the first page in [from, to) that is in use, or that has only zeros, or `to` if none is. */
export function seekPage(findPage: FindPage, from: number, to: number, sought: 'used' | 'zero'): number {
  return unsigned(findPage(from, to, PAGE_BYTES, sought === 'used' ? 1 : 0));
}

/** Writes zeros over [from, to), and only where something else is: untouched pages stay so. */
export function clearMemory({ buffer }: WebAssembly.Memory, findPage: FindPage, from: number, to: number): void {
  const bytes = new Uint8Array(buffer);
  const first = Math.min(to, Math.ceil(from / PAGE_BYTES) * PAGE_BYTES);
  bytes.fill(0, from, first);
  const last = Math.max(first, Math.floor(to / PAGE_BYTES) * PAGE_BYTES);
  for (let at = first; at < last; ) {
    const used = seekPage(findPage, at, last, 'used');
    at = seekPage(findPage, used, last, 'zero');
    bytes.fill(0, used, at);
  }
  bytes.fill(0, last, to);
}
