// Elementary functions and random numbers for TypeScript; kernels import the files. The logarithm stands in the core
// module, because random numbers need it: a game that needs no other function does not carry this module.
export { sine, cosine, arcTangent2, exponential } from './elementary';
export { power } from './power';
export { noise } from './noise';
export { randomWord, randomUnit, randomNormal } from './random';
