// The kernels of wind on cloth and of gas in soft bodies, on every world that has either.
import { KERNELS, type KernelExports } from '../kernels/soft-bodies.gen.ts';
import { kernelModule } from '../memory/kernel-module.ts';

export const softBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
