import { integrate } from '../dynamics/integrate.ts';
import { integrateRotation } from '../dynamics/integrate-rotation.ts';
import { beginStep, validateMotion, validateState } from '../dynamics/validate-state.ts';
import { assertPresetWorld } from '../ecs/guards.ts';
import type { Precision } from '../kernels/instantiate.ts';
import { collideBodies, enableContacts } from '../particle-contacts/collide.ts';
import { contactBytesPerEntity } from '../particle-contacts/contact-table.ts';
import { dispatchContactEvents } from '../particle-contacts/contacts.ts';
import { planeWalls } from '../particle-contacts/plane-walls.ts';
import { segmentWalls } from '../particle-contacts/segment-walls.ts';
import { dispatchFaultEvents } from '../world/event-handlers.ts';
import type { PhysicsWorld, Preset } from '../world/types.ts';

/**
 * `standard` with collisions: round bodies collide with each other, SegmentWalls and PlaneWalls; `contacts(world)`
 * lists the contacts. Walls passed to `createPhysicsWorld`, such as `boxWalls`, run after the wall entities.
 *
 * Values are also validated before collisions, so that an invalid value from a force does not spread to other bodies.
 */
export const particleContacts: Preset = /* @__PURE__ */ Object.assign(fill, {
  // The default memory is added, because other features may need it.
  bytesPerEntity: (dimensions: 2 | 3, precision: Precision) => 256 + contactBytesPerEntity(dimensions, precision),
});

function fill(world: PhysicsWorld): void {
  assertPresetWorld(world, 'particleContacts');
  const { phases } = world;
  // Allocates the memory immediately, so that a world too small for contacts fails at its creation.
  enableContacts(world);
  phases.begin.push(enableContacts, beginStep);
  phases.integrate.push(integrate, integrateRotation);
  phases.walls.push(segmentWalls, planeWalls);
  phases.collide.push(validateMotion, collideBodies);
  phases.finish.push(validateState);
  phases.events.push(dispatchFaultEvents, dispatchContactEvents);
}
