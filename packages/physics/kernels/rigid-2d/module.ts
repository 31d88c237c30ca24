// Rigid bodies in two dimensions form a separate module, so that games without them do not load it.
export { collidePair } from '../collision/narrow-phase/2d/collide-shapes';
export { sweepPair } from '../collision/narrow-phase/2d/time-of-impact';
export { nextNearBody } from '../collision/queries/2d/nearest-point';
export { collectCandidates, rememberPoses, treesHold } from '../collision/queries/2d/query-trees';
export { nextRayHit } from '../collision/queries/2d/ray-cast';
export { castMeetsWall, isNearWall, placePlane, placeSegment, rayMeetsWall } from '../collision/queries/2d/walls';
export { nextShapeHit } from '../collision/queries/2d/shape-cast';
export { findRigidPairs } from '../collision/broad-phase/2d/find-pairs';
export { clearContacts } from '../collision/narrow-phase/2d/contact-list';
export { ignorePair, newPair } from '../collision/narrow-phase/2d/new-pairs';
export { updateContacts, wakeIslands } from '../collision/narrow-phase/2d/update-contacts';
export { gatherBodies } from '../solver/2d/gather-bodies';
export { integratePositions, integrateVelocities, writeAngles, writeBodies } from '../solver/2d/integrate-bodies';
export { assignWallShapes, countInvalidWalls } from '../solver/2d/walls';
export { holdLocked } from '../solver/2d/motion-locks';
export { writeParts } from '../solver/2d/parts';
export { colorContacts } from '../solver/2d/color-contacts';
export {
  endCrowds,
  findCrowds,
  limitCrowdEnergies,
  limitCrowdSpeeds,
  measureCrowds,
} from '../solver/2d/crowds';
export { prepareContacts, storeImpulses } from '../solver/2d/prepare-contacts';
export { scaleContactImpulses } from '../solver/2d/scale-impulses';
export { relaxContacts, solveContacts, warmStartContacts } from '../solver/2d/solve-contacts';
export { scaleJointImpulses } from '../joints/2d/scale-impulses';
export { listContactEvents } from '../solver/2d/contact-events';
export { stopFastBodies } from '../solver/2d/continuous';
export { islandAt, labelIslands, updateSleep } from '../solver/2d/islands';
export { endLandings, slowLandings } from '../impacts/2d/landings';
export { applyRestitution } from '../impacts/2d/restitution';
export { hasNewCollisions, listJoints } from '../joints/2d/list-joints';
export { prepareJoints } from '../joints/2d/prepare-joints';
export { noteSettings } from '../joints/2d/wake-joints';
export { startJoints } from '../joints/2d/start-joints';
export { closeTorn } from '../joints/2d/torn-trees';
export { listBroken } from '../joints/2d/watch-joints';
export { solveAxes } from '../joints/2d/solve-axes';
export { relaxLocks, solveLocks } from '../joints/2d/solve-locks';
export { nextContactPoint } from '../debug/2d/contact-points';
