// Collisions between bodies and with wall entities form a separate module, so that games without them do not load it.
export { findPairs } from './pairs';
export { beginContacts, beginWallContacts, sortContacts } from './order';
export { omitLinked } from './linked';
export { respondToImpacts, settleContacts } from './respond';
export { gatherSegments } from './walls/wall-grid';
export { clampToSegments, segmentWalls } from './walls/segments';
export { planeWalls } from './walls/planes';
