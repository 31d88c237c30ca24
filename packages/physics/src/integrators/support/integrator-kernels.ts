import { KERNELS, type KernelExports } from '../../kernels/integrators.gen.ts';
import { kernelModule } from '../../memory/kernel-module.ts';

/** The kernels of multi-stage schemes, for a world. */
export const integratorKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
