// Rotation of bodies with an inertia tensor, in a separate module that a world instantiates with its first such body. It
// computes in f64 for worlds of both precisions and is compiled once.
export { kickTensor, rotateRigidly } from './rotate-rigidly';
export { spinEnergy, spinMomentum } from './spin';
