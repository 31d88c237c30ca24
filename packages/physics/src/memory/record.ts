import { type Arena, allocate } from './arena.ts';

/**
 * A record of the kernels in the world's memory. Its layout, the indices of the fields in `words` and `numbers`, is in
 * `layouts.gen.ts`.
 */
export interface MemoryRecord {
  /** Its address. */
  readonly at: number;
  /** The whole record, for its fields of four bytes. */
  readonly words: Uint32Array;
  /** The whole record, for its f64 fields. */
  readonly numbers: Float64Array;
}

/** The record of so many bytes at an address, a multiple of eight. */
export function recordAt({ buffer }: WebAssembly.Memory, at: number, bytes: number): MemoryRecord {
  return {
    at,
    words: new Uint32Array(buffer, at, Math.floor(bytes / 4)),
    numbers: new Float64Array(buffer, at, Math.floor(bytes / 8)),
  };
}

/**
 * A new record, all zero.
 * @throws PhysicsError E_CAPACITY when the arena is full
 */
export function allocateRecord(arena: Arena, bytes: number, what: string): MemoryRecord {
  return recordAt(arena.memory, allocate(arena, bytes, what), bytes);
}
