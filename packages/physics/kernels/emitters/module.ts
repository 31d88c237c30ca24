// Particle pools and what bears and ends their particles.
export { prepareEmitter } from './appearance';
export { openPool } from './pool';
export { stepEmitter } from './step';
