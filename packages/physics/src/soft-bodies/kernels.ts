// The kernels of wind on cloths and of gas in soft bodies, for worlds with either.
import { KERNELS, type KernelExports } from '../kernels/soft-bodies.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const softBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
