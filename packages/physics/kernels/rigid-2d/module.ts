// Rigid bodies in two dimensions form a separate module, so that games without them do not load it.
export { collidePair, collidePairs } from '../collision/narrow-phase/2d/collide-shapes';
export { findRigidPairs } from '../collision/broad-phase/2d/find-pairs';
export { clearContacts } from '../collision/narrow-phase/2d/contact-list';
export { updateContacts } from '../collision/narrow-phase/2d/update-contacts';
export { gatherBodies } from '../solver/2d/gather-bodies';
export { integratePositions, integrateVelocities, writeAngles, writeBodies } from '../solver/2d/integrate-bodies';
export { colorContacts } from '../solver/2d/color-contacts';
export { prepareContacts, storeImpulses } from '../solver/2d/prepare-contacts';
export { relaxContacts, solveContacts, warmStartContacts } from '../solver/2d/solve-contacts';
export { applyRestitution } from '../solver/2d/restitution';
export { measureJoints } from '../joints/2d/measure-joints';
export { listBroken, listJoints, prepareJoints, warmStartJoints, watchJoints } from '../joints/2d/prepare-joints';
export { solveAxes } from '../joints/2d/solve-axes';
export { factorJoints, solveLocks } from '../joints/2d/solve-locks';
