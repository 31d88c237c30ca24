// Kernels of force laws that not every world needs, in a separate module to keep other bundles small.
export { gatherCharges } from './charges';
export { burnFuel } from './rocket-engines';
export { restoreOutside, zeroOutside } from './restrict-force';
export { postNewtonian } from './post-newtonian';
