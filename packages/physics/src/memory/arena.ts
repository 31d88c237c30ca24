import { PhysicsError } from '../errors/physics-error.ts';

const PAGE = 65536;

/**
 * The world's one block of memory and the next free byte of it. Nothing is ever given back: what a world needs is
 * allocated when the world or a feature is made, and pages are not touched until they are used.
 */
export interface Arena {
  readonly memory: WebAssembly.Memory;
  readonly bytes: number;
  top: number;
  staggered: number;
}

/**
 * A fixed block of at least `bytes`.
 * @throws PhysicsError E_CAPACITY when the machine or the 4 GiB address space cannot hold it
 */
export function createArena(bytes: number, reserved: number): Arena {
  const pages = Math.ceil(bytes / PAGE);
  let memory: WebAssembly.Memory;
  try {
    memory = new WebAssembly.Memory({ initial: pages, maximum: pages });
    if (memory.buffer.byteLength < pages * PAGE) throw new RangeError('the memory is smaller than asked for');
  } catch (cause) {
    const error = new PhysicsError('E_CAPACITY', `no memory for ${(bytes / 2 ** 20).toFixed(0)} MiB.`, {
      field: 'capacity',
      hint: 'A world has 4096 at most: lower `capacity`, or use precision "f32".',
    });
    error.cause = cause;
    throw error;
  }
  return { memory, bytes: pages * PAGE, top: reserved, staggered: 0 };
}

/**
 * The address of `bytes` fresh zero bytes, 64-byte aligned. Columns get starts that differ modulo 4096, so that walking
 * a dozen of them in step does not fight over the same cache sets.
 * @throws PhysicsError E_CAPACITY when the arena is full
 */
export function allocate(arena: Arena, bytes: number, what: string): number {
  const STAGGER = 320;
  const aligned = Math.ceil(arena.top / 4096) * 4096;
  const address = bytes >= 4096 ? aligned + ((arena.staggered++ * STAGGER) % 4096) : Math.ceil(arena.top / 64) * 64;
  if (address + bytes > arena.bytes) {
    throw new PhysicsError('E_CAPACITY', `no room in the world's memory for ${what} (${bytes} bytes).`, {
      field: 'arenaBytes',
      hint: 'Make the world with a larger `arenaBytes`.',
    });
  }
  arena.top = address + bytes;
  return address;
}
