// Springs solved as XPBD constraints, and the wind, gas pressure and breakage of the soft bodies that they form.
export { arrangeConstraints } from './arrange';
export { solveChainVelocities, solveChains } from './chain';
export { enclosed, inflateEdges, inflateTriangles } from './gas';
export { kickNodes, packBodies, unpackBodies } from './nodes';
export { findBroken, findOverloaded, maxStrain, readConstraints, rmsStrain } from './rows';
export { sweepConstraints } from './sweep';
export { dampConstraints } from './velocities';
export { blowTriangles } from './wind';
