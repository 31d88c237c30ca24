import { KERNELS, type KernelExports } from '../kernels/emitters.gen';
import { kernelModule } from '../kernels/instantiate';

/** The kernels of emitters, for a world. */
export const emitterKernels = kernelModule<KernelExports>(KERNELS);
