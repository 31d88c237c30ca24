// The kernels of bodies with an inertia tensor: a separate module, instantiated when a world first has such a body.
import { KERNELS, type KernelExports } from '../kernels/rotation.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const rotationKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
