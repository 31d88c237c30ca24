import { kernelModule } from '../kernels/instantiate';
import { KERNELS, type KernelExports } from '../kernels/integrators.gen';

/** The kernels of the schemes of many stages, on a world that uses one. */
export const integratorKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
