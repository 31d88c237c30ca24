import { KERNELS, type KernelExports } from '../kernels/rigid-2d.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

/** The kernels of rigid bodies in two dimensions, for a world. */
export const rigidKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
