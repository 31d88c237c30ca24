// Elementary functions and random numbers for TypeScript; kernels import the files.
export { sine, cosine, arcTangent2, exponential, logarithm } from './elementary';
export { power } from './power';
export { randomWord, randomUnit, randomNormal } from './random';
