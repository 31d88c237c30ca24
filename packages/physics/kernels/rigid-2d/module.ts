// Rigid bodies in two dimensions form a separate module, so that games without them do not load it.
export { collidePair, collidePairs } from '../collision/narrow-phase/2d/collide-shapes';
