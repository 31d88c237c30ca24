// Collisions of bodies, and the walls that are entities: a module of its own, so that a game without them does not pay.
export { findPairs } from './pairs';
export { beginContacts, beginWallContacts, sortContacts } from './order';
export { respond } from './respond';
export { gatherSegments } from './walls/wall-grid';
export { confineToSegments, segmentWalls } from './walls/segments';
export { planeWalls } from './walls/planes';
