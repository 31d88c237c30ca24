// Springs solved as XPBD constraints, and their breakage.
export { arrangeConstraints } from './arrange';
export { solveChainVelocities, solveChains } from './chain';
export { kickNodes, packBodies, unpackBodies } from './nodes';
export { findBroken, findOverloaded, maxStrain, readConstraints, rmsStrain } from './rows';
export { sweepConstraints } from './sweep';
export { dampConstraints } from './velocities';
