import { PhysicsError } from '../errors/physics-error.ts';

const PAGE = 65536;

/**
 * The world's block of memory with a bump allocator. Memory is never freed: a world or feature allocates at creation,
 * and pages are not touched until used.
 */
export interface Arena {
  readonly memory: WebAssembly.Memory;
  readonly bytes: number;
  top: number;
  staggered: number;
}

/**
 * Creates a fixed block of at least `bytes`.
 * @throws PhysicsError E_CAPACITY if the machine or the 4 GiB address space cannot hold it
 */
export function createArena(bytes: number, reserved: number): Arena {
  const pages = Math.ceil(bytes / PAGE);
  let memory: WebAssembly.Memory;
  try {
    memory = new WebAssembly.Memory({ initial: pages, maximum: pages });
    if (memory.buffer.byteLength < pages * PAGE) throw new RangeError('the memory is smaller than requested');
  } catch (cause) {
    const error = new PhysicsError('E_CAPACITY', `cannot allocate ${(bytes / 2 ** 20).toFixed(0)} MiB of memory.`, {
      field: 'capacity',
      hint: 'A world can have at most 4096 MiB: lower `capacity`, or use precision "f32".',
    });
    error.cause = cause;
    throw error;
  }
  return { memory, bytes: pages * PAGE, top: reserved, staggered: 0 };
}

/**
 * Allocates `bytes` zero bytes, 64-byte aligned, and returns their address. The addresses of columns differ modulo
 * 4096, so that loops over a dozen columns do not compete for the same cache sets.
 * @param hint what to do where there is no room
 * @throws PhysicsError E_CAPACITY if the arena is full
 */
export function allocate(
  arena: Arena,
  bytes: number,
  what: string,
  hint = 'Create the world with a larger `arenaBytes`.',
): number {
  const STAGGER = 320;
  const aligned = Math.ceil(arena.top / 4096) * 4096;
  const address = bytes >= 4096 ? aligned + ((arena.staggered++ * STAGGER) % 4096) : Math.ceil(arena.top / 64) * 64;
  if (address + bytes > arena.bytes) {
    throw new PhysicsError('E_CAPACITY', `the arena of the world has no room for ${what} (${bytes} bytes).`, {
      field: 'arenaBytes',
      hint,
    });
  }
  arena.top = address + bytes;
  return address;
}
