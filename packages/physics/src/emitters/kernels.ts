import { KERNELS, type KernelExports } from '../kernels/emitters.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

/** The kernels of emitters, for a world. */
export const emitterKernels = kernelModule<KernelExports>(KERNELS);
