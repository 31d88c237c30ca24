import type { PhysicsWorld } from '../world';
import { decodeModule, type EmbeddedModule } from './decode';
import { KERNELS_F32, KERNELS_F64, type KernelExports } from './modules.gen';

export type Precision = 'f32' | 'f64';
export type { KernelExports };

/** The two builds of a kernel module, and what was compiled of them in this process. */
interface KernelModule {
  readonly f32: EmbeddedModule;
  readonly f64: EmbeddedModule;
  readonly compiled: { f32?: WebAssembly.Module; f64?: WebAssembly.Module };
}

const core: KernelModule = { f32: KERNELS_F32, f64: KERNELS_F64, compiled: {} };

/** The kernels every world has. Compiling is synchronous and done once a process and precision. */
export function instantiateKernels(precision: Precision, memory: WebAssembly.Memory): KernelExports {
  return instantiate(core, precision, memory) as unknown as KernelExports;
}

function instantiate(kernels: KernelModule, precision: Precision, memory: WebAssembly.Memory): WebAssembly.Exports {
  let module = kernels.compiled[precision];
  if (module === undefined) {
    module = new WebAssembly.Module(decodeModule(kernels[precision]));
    kernels.compiled[precision] = module;
  }
  return new WebAssembly.Instance(module, { env: { memory } }).exports;
}

/**
 * The kernels of a feature, on each world that asks for them. A game that does not import the feature does not carry
 * them: `const kernels = kernelModule<NBodyKernels>(KERNELS_F32, KERNELS_F64)`, then `kernels(world).walk(…)`.
 */
export function kernelModule<Exports>(f32: EmbeddedModule, f64: EmbeddedModule): (world: PhysicsWorld) => Exports {
  const kernels: KernelModule = { f32, f64, compiled: {} };
  return ({ internal, precision, memory }) => {
    let exports = internal.resources.get(kernels);
    if (exports === undefined) {
      exports = instantiate(kernels, precision, memory);
      internal.resources.set(kernels, exports);
    }
    return exports as Exports;
  };
}
