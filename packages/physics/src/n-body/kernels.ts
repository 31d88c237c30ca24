// The kernels of mutual forces, instantiated for worlds with such a force.
import { KERNELS, type KernelExports } from '../kernels/n-body.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const nBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
