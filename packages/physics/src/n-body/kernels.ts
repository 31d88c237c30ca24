// The kernels of mutual forces, on every world that has one.
import { kernelModule } from '../kernels/instantiate';
import { KERNELS_F32, KERNELS_F64, type KernelExports } from '../kernels/n-body.gen';

export const nBodyKernels = /* @__PURE__ */ kernelModule<KernelExports>(KERNELS_F32, KERNELS_F64);
