// Particle pools: emitters, births, ageing and ends of particles.
export { prepareEmitter } from './appearance';
export { advanceNewborns, findNewborns, nextNewborns } from './newborns';
export { openPool } from './pool';
export { stepEmitter } from './step';
