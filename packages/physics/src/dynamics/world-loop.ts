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

/** Compiles the loop identified by `key`, unless it is cached, and instantiates it over the memory of the world. */
export function makeWorldLoop(world: PhysicsWorld, key: string, make: () => LoopSource): WorldLoop {
  const compiled = compileLoop(key, make);
  return { compiled, run: instantiateLoop(compiled, world.memory, () => mathImports(world)) };
}
