// The kernels of the laws beyond drag, springs, attraction and uniform gravity: a module of its own, made when a world
// first uses one of them.
import { KERNELS, type KernelExports } from '../../kernels/forces.gen.ts';
import { kernelModule } from '../../memory/kernel-module.ts';

export const forceKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
