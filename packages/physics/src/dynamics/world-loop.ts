// A compiled loop over the columns of one world.
import { type CompiledLoop, compileLoop, instantiateLoop, type Loop } from '../laws/compile.ts';
import type { LoopSource } from '../laws/loop-source.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { mathImports } from './math-imports.ts';

export interface WorldLoop {
  /** The module and its source, for printing. */
  readonly compiled: CompiledLoop;
  readonly run: Loop;
}

/** The loops of each memory: a world that makes its plan anew, as after a restore, finds them. */
const loops = new WeakMap<WebAssembly.Memory, WeakMap<CompiledLoop, Loop>>();

function loopOf(world: PhysicsWorld, compiled: CompiledLoop): Loop {
  const { memory } = world;
  const known = loops.get(memory) ?? new WeakMap<CompiledLoop, Loop>();
  loops.set(memory, known);
  // Nothing but memory changes as a loop runs.
  const run = known.get(compiled) ?? instantiateLoop(compiled, memory, () => mathImports(world));
  known.set(compiled, run);
  return run;
}

/** The loop identified by `key` over the memory of the world: compiled and instantiated unless it is cached. */
export function makeWorldLoop(world: PhysicsWorld, key: string, make: () => LoopSource): WorldLoop {
  const compiled = compileLoop(key, make);
  return { compiled, run: loopOf(world, compiled) };
}
