// Rigid bodies in two dimensions form a separate module, so that games without them do not load it.
export { collidePair } from '../collision/narrow-phase/2d/collide-shapes';
export { sweepPair } from '../collision/narrow-phase/2d/time-of-impact';
export { nextNearBody } from '../collision/queries/2d/nearest-point';
export { nextRayHit } from '../collision/queries/2d/ray-cast';
export { nextShapeHit } from '../collision/queries/2d/shape-cast';
export { findRigidPairs } from '../collision/broad-phase/2d/find-pairs';
export { clearContacts } from '../collision/narrow-phase/2d/contact-list';
export { updateContacts } from '../collision/narrow-phase/2d/update-contacts';
export { gatherBodies } from '../solver/2d/gather-bodies';
export { integratePositions, integrateVelocities, writeAngles, writeBodies } from '../solver/2d/integrate-bodies';
export { colorContacts } from '../solver/2d/color-contacts';
export { prepareContacts, storeImpulses } from '../solver/2d/prepare-contacts';
export { relaxContacts, solveContacts, warmStartContacts } from '../solver/2d/solve-contacts';
export { applyRestitution } from '../solver/2d/restitution';
