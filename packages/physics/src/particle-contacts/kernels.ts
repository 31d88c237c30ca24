// The kernels of collisions and wall entities, a separate module that a world instantiates on first use.
import { KERNELS, type KernelExports } from '../kernels/particle-contacts.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const collisionKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
