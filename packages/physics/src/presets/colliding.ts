import { collideBodies, openContacts } from '../collision/collide';
import { tellContacts } from '../collision/contacts';
import { planeWalls } from '../collision/plane-walls';
import { segmentWalls } from '../collision/segment-walls';
import { tellFaults } from '../events/handlers';
import { integrate } from '../integrators/integrate';
import { turn } from '../integrators/turn';
import { begin, checkFinite } from '../schedule/quarantine';
import type { Preset } from './preset';

/**
 * `standard` with collisions: round bodies meet each other, SegmentWalls and PlaneWalls; `contacts(world)` lists what
 * met. Walls given to `createPhysicsWorld`, such as `boxWalls`, come after the wall entities.
 *
 * Values are checked before bodies meet as well, so that what a force made of one body does not pass to another.
 */
export const colliding: Preset = (world) => {
  const { phases } = world;
  // Takes the memory now, so that a world too small for contacts fails when it is made.
  openContacts(world);
  phases.begin.push(openContacts, begin);
  phases.integrate.push(integrate, turn);
  phases.walls.push(segmentWalls, planeWalls);
  phases.collide.push(checkFinite, collideBodies);
  phases.finish.push(checkFinite);
  phases.events.push(tellFaults, tellContacts);
};
