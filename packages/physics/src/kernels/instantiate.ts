import { compileBytes } from './compile-bytes.ts';
import { decodeModule, type EmbeddedModule } from './decode.ts';
import { KERNELS, type KernelExports } from './modules.gen.ts';

export type Precision = 'f32' | 'f64';
export type { KernelExports };

/** The kernels every world has. */
export function instantiateKernels(precision: Precision, memory: WebAssembly.Memory): KernelExports {
  return instantiate<KernelExports>(KERNELS, precision, memory);
}

/**
 * The functions of one build of a module, by name. Compiling is synchronous and done once a process and precision.
 */
export function instantiate<Exports>(
  kernels: EmbeddedModule,
  precision: Precision,
  memory: WebAssembly.Memory,
): Exports {
  kernels.compiled[precision] ??= compileBytes(decodeModule(kernels, precision));
  const functions = Object.values(new WebAssembly.Instance(kernels.compiled[precision], { env: { memory } }).exports);
  return Object.fromEntries(kernels.names.split('.').map((name, i) => [name, functions[i]])) as Exports;
}
