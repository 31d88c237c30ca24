// From a loop as arithmetic to a function that runs over the memory of a world. Modules are compiled synchronously and
// kept: a world of the same structure and layout uses the one there is.
import { compileBytes } from '../kernels/compile-bytes.ts';
import { emitLoop, type LoopSource } from './emit-loop.ts';
import { encodeModule, type ModuleSource } from './encode.ts';

/** Runs over rows [first, last), whose bounds are multiples of 16. */
export type Loop = (first: number, last: number, checked: number) => number;

/** A compiled module, and how to print it. */
export interface CompiledLoop {
  readonly module: WebAssembly.Module;
  readonly source: ModuleSource;
}

/** What was compiled in this process, by structure and layout: the oldest goes when there are too many. */
const compiled = new Map<string, CompiledLoop>();
const MAX_COMPILED = 256;

/** The module of a loop that is described by `key`; `make` describes it in full when it is not known yet. */
export function compileLoop(key: string, make: () => LoopSource): CompiledLoop {
  const known = compiled.get(key);
  if (known !== undefined) return known;
  const source = emitLoop(make());
  const made = { module: compileBytes(encodeModule(source)), source };
  if (compiled.size >= MAX_COMPILED) compiled.delete(compiled.keys().next().value as string);
  compiled.set(key, made);
  return made;
}

/** The function of a module over a memory. `functions` gives those that it imports, if it imports any. */
export function instantiateLoop(
  { module, source }: CompiledLoop,
  memory: WebAssembly.Memory,
  functions: () => Readonly<Record<string, unknown>>,
): Loop {
  const math = source.imports.length === 0 ? {} : (functions() as Record<string, WebAssembly.ImportValue>);
  const imports = { env: { memory }, math };
  return new WebAssembly.Instance(module, imports).exports[source.name] as unknown as Loop;
}
