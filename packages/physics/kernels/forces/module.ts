// The force laws beyond those every world carries: a module of its own, so that a game without them does not pay.
export { gatherCharges } from './charges';
export { burnFuel, blast } from './external-forces';
export { restoreOutside, zeroOutside } from './restrict-force';
export { postNewtonian } from './post-newtonian';
