// Elementary functions and random numbers for TypeScript and for fused laws; kernels import the files directly. All
// compute in f64, whatever the precision of the world.
export { sine, cosine, arcTangent2, exponential, logarithm } from './elementary';
export { power } from './power';
export { noise } from './noise';
export { randomWord, randomUnit, randomNormal } from './random';
