// The kernels of mutual forces, on every world that has one.
import { kernelModule } from '../kernels/instantiate';
import { KERNELS, type KernelExports } from '../kernels/n-body.gen';

export const nBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS);
