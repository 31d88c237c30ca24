// The kernels of mutual forces, on every world that has one.
import { kernelModule } from '../kernels/instantiate.ts';
import { KERNELS, type KernelExports } from '../kernels/n-body.gen.ts';

export const nBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
