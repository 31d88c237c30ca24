// Particle pools and what bears and ends their particles.
export { prepareEmitter } from './looks';
export { openPool } from './pool';
export { stepEmitter } from './step';
