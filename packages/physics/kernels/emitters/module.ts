// Particle pools and what bears and ends their particles.
export { openPool } from './pool';
export { stepEmitter } from './step';
