// The force laws beyond those every world carries: a module of its own, so that a game without them does not pay.
export { centralForce, centralPotential } from './central';
export { magneticForce2d, magneticForce3d, gatherCharges, coulombForce, coulombPotential } from './electromagnetic';
export { sphereDrag, liftForce, magnusForce } from './fluid';
export {
  upthrust,
  upthrustPotential,
  balloonPotential,
  immersedDrag,
  addedMass,
  polygonUpthrust,
  polygonPotential,
} from './immersion';
export { turbulentDrag } from './turbulence';
export { pushAxis, addToRow, noiseForce, turnedForce2d, turnedForce3d, burnFuel, motorForce, blast } from './push';
export { stringTension, bendForce, supportForce } from './reaction';
export { restoreOutside, zeroOutside } from './limited';
export { postNewtonian } from './post-newtonian';
