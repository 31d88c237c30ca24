// Springs solved as constraints, and what blows on, fills and breaks networks of them.
export { arrangeConstraints } from './arrange';
export { solveChainVelocities, solveChains } from './chain';
export { enclosed, inflateEdges, inflateTriangles } from './gas';
export {
  findBroken,
  findOverloaded,
  kickNodes,
  largestStretch,
  packBodies,
  readConstraints,
  unpackBodies,
} from './rows';
export { sweepConstraints } from './sweep';
export { dampConstraints } from './velocities';
export { blowTriangles } from './wind';
