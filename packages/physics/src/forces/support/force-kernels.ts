// The kernels of laws beyond drag, springs, attraction and uniform gravity: a separate module, instantiated when a
// world first uses it.
import { KERNELS, type KernelExports } from '../../kernels/forces.gen.ts';
import { kernelModule } from '../../memory/kernel-module.ts';

export const forceKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
