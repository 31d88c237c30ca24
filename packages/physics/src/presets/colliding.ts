import { collideBodies, openContacts } from '../collision/collide';
import { contactBytesPerEntity } from '../collision/contact-table';
import { tellContacts } from '../collision/contacts';
import { planeWalls } from '../collision/plane-walls';
import { segmentWalls } from '../collision/segment-walls';
import { integrate } from '../dynamics/integrate';
import { tellFaults } from '../events/handlers';
import { turn } from '../integrators/turn';
import type { Precision } from '../kernels/instantiate';
import { begin, checkFinite } from '../schedule/quarantine';
import type { PhysicsWorld } from '../world';
import type { Preset } from './preset';

/**
 * `standard` with collisions: round bodies meet each other, SegmentWalls and PlaneWalls; `contacts(world)` lists what
 * met. Walls given to `createPhysicsWorld`, such as `boxWalls`, come after the wall entities.
 *
 * Values are checked before bodies meet as well, so that what a force made of one body does not pass to another.
 */
export const colliding: Preset = /* @__PURE__ */ Object.assign(fill, {
  // Others may need what a world has by default.
  bytesPerEntity: (dimensions: 2 | 3, precision: Precision) => 256 + contactBytesPerEntity(dimensions, precision),
});

function fill(world: PhysicsWorld): void {
  const { phases } = world;
  // Takes the memory now, so that a world too small for contacts fails when it is made.
  openContacts(world);
  phases.begin.push(openContacts, begin);
  phases.integrate.push(integrate, turn);
  phases.walls.push(segmentWalls, planeWalls);
  phases.collide.push(checkFinite, collideBodies);
  phases.finish.push(checkFinite);
  phases.events.push(tellFaults, tellContacts);
}
