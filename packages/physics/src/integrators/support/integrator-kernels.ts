import { KERNELS, type KernelExports } from '../../kernels/integrators.gen.ts';
import { kernelModule } from '../../memory/kernel-module.ts';

/** The kernels of the schemes of many stages, on a world that uses one. */
export const integratorKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
