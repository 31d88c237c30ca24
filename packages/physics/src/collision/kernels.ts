// The kernels of collisions and of walls that are entities: a module of its own, made when a world first uses them.
import { KERNELS, type KernelExports } from '../kernels/collision.gen';
import { kernelModule } from '../kernels/instantiate';

export const collisionKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
