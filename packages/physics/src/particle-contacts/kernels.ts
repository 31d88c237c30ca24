// The kernels of collisions and of walls that are entities: a module of its own, made when a world first uses them.
import { KERNELS, type KernelExports } from '../kernels/particle-contacts.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const collisionKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
