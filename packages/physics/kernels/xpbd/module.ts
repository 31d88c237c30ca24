// Springs solved as constraints, and what blows on, fills and breaks networks of them.
export { arrangeConstraints } from './arrange';
export { solveChainVelocities, solveChains } from './chain';
export { enclosed, inflateEdges, inflateTriangles } from './gas';
export { kickNodes, packBodies, unpackBodies } from './nodes';
export { findBroken, findOverloaded, maxStrain, readConstraints, rmsStrain } from './rows';
export { sweepConstraints } from './sweep';
export { dampConstraints } from './velocities';
export { blowTriangles } from './wind';
