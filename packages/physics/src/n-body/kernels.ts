// The kernels of mutual forces, on every world that has one.
import { KERNELS, type KernelExports } from '../kernels/n-body.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const nBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
