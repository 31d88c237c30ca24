// Mutual forces between many bodies: a module of its own, because only worlds with such a force need it.
export { nBodyBegin, nBodyBytes } from './workspace';
export { nBodyGather, nBodyScatter } from './gather';
export { nBodyError, nBodyEvaluate } from './forces';
export { nBodyPotential } from './potential';
