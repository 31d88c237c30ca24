// Mutual forces between many bodies form a separate module, because only worlds with such a force need it.
export { nBodyBegin, nBodyBytes } from './workspace';
export { nBodyGather, nBodyScatter } from './gather';
export { nBodyError, nBodyEvaluate } from './forces';
export { nBodyPotential } from './potential';
