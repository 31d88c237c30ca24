// Compiles the arithmetic of a loop to a function over the memory of a world. Modules are compiled synchronously and
// cached: worlds of equal structure and layout share them.
import { compileBytes } from '../kernels/compile-bytes.ts';
import { emitLoop } from './emit-loop.ts';
import { encodeModule, type ModuleSource } from './encode.ts';
import type { LoopSource } from './loop-source.ts';

/** Processes rows [first, last), whose bounds are multiples of 16. */
export type Loop = (first: number, last: number, checked: number) => number;

/** A compiled module and its printable source. */
export interface CompiledLoop {
  readonly module: WebAssembly.Module;
  readonly source: ModuleSource;
  /** Vectors per iteration. */
  readonly vectors: number;
}

/** Cache of the process, keyed by structure and layout; the oldest entry is evicted when it is full. */
const compiled = new Map<string, CompiledLoop>();
const MAX_COMPILED = 256;

/** Returns the module of the loop identified by `key`; `make` builds the loop if it is not cached. */
export function compileLoop(key: string, make: () => LoopSource): CompiledLoop {
  const cached = compiled.get(key);
  if (cached !== undefined) return cached;
  const loop = make();
  const source = emitLoop(loop);
  const made = { module: compileBytes(encodeModule(source)), source, vectors: loop.vectors ?? 1 };
  if (compiled.size >= MAX_COMPILED) compiled.delete(compiled.keys().next().value as string);
  compiled.set(key, made);
  return made;
}

/** Instantiates a module over a memory. `functions` provides its imports, if it has any. */
export function instantiateLoop(
  { module, source }: CompiledLoop,
  memory: WebAssembly.Memory,
  functions: () => Readonly<Record<string, unknown>>,
): Loop {
  const math = source.imports.length === 0 ? {} : (functions() as Record<string, WebAssembly.ImportValue>);
  const imports = { env: { memory }, math };
  return new WebAssembly.Instance(module, imports).exports[source.name] as unknown as Loop;
}
