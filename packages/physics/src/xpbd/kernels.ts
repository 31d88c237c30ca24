import { KERNELS, type KernelExports } from '../kernels/xpbd.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

/** The kernels of constraints of a world. */
export const constraintKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
