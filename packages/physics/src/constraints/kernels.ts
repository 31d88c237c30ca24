import { KERNELS, type KernelExports } from '../kernels/constraints.gen';
import { kernelModule } from '../kernels/instantiate';

/** The kernels of constraints and networks, for a world. */
export const constraintKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
