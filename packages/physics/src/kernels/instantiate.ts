import { decodeModule } from './decode';
import { KERNELS_F32, KERNELS_F64, type KernelExports } from './modules.gen';

export type Precision = 'f32' | 'f64';
export type { KernelExports };

const compiled: { f32?: WebAssembly.Module; f64?: WebAssembly.Module } = {};

/** The kernels of one precision on one memory. Compiling is synchronous and done once a process and precision. */
export function instantiateKernels(precision: Precision, memory: WebAssembly.Memory): KernelExports {
  let module = compiled[precision];
  if (module === undefined) {
    module = new WebAssembly.Module(decodeModule(precision === 'f32' ? KERNELS_F32 : KERNELS_F64));
    compiled[precision] = module;
  }
  return new WebAssembly.Instance(module, { env: { memory } }).exports as unknown as KernelExports;
}
