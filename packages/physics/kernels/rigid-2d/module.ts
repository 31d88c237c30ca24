// Rigid bodies in two dimensions form a separate module, so that games without them do not load it.
export { collidePair } from '../collision/narrow-phase/2d/collide-shapes';
export { sweepPair } from '../collision/narrow-phase/2d/time-of-impact';
export { nextNearBody } from '../collision/queries/2d/nearest-point';
export { nextRayHit } from '../collision/queries/2d/ray-cast';
export { nextShapeHit } from '../collision/queries/2d/shape-cast';
