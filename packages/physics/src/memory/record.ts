import { type Arena, allocate } from './arena.ts';

/**
 * A kernel record in the world's memory. `layouts.gen.ts` has the indices of its fields in `words` and `numbers`.
 */
export interface MemoryRecord {
  /** Its address. */
  readonly at: number;
  /** The whole record, for its fields of four bytes. */
  readonly words: Uint32Array;
  /** The whole record, for its f64 fields. */
  readonly numbers: Float64Array;
}

/** Returns the record of `bytes` bytes at an address, which is a multiple of eight. */
export function recordAt({ buffer }: WebAssembly.Memory, at: number, bytes: number): MemoryRecord {
  return {
    at,
    words: new Uint32Array(buffer, at, Math.floor(bytes / 4)),
    numbers: new Float64Array(buffer, at, Math.floor(bytes / 8)),
  };
}

/**
 * Allocates a record, all zero.
 * @throws PhysicsError E_CAPACITY when the arena is full
 */
export function allocateRecord(arena: Arena, bytes: number, what: string): MemoryRecord {
  return recordAt(arena.memory, allocate(arena, bytes, what), bytes);
}
