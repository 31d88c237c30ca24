// Collisions of round bodies: discs in 2D, balls in 3D.
//
//   broad phase            uniform grid of hashed cells                       grid.ts, pairs.ts
//   order                  ascending (a, b)                                   order.ts
//   impacts                restitution and friction at the time of impact     impacts.ts
//   the same again         under forces that depend on position or velocity   src/particle-contacts/retake-contacts.ts
//   resting contacts       sequential impulses with warm starting             resting-contacts.ts
//   position correction    displacement at bounded speed                      position-correction.ts
//   wide contacts          SIMD form of the two solvers above                 wide-contacts.ts
//
// The files are in kernels/particle-contacts. The restitution of a contact is the larger of the two bodies', its
// friction coefficient their geometric mean, as for walls. Contacts are found at the end of the step: bodies that pass
// through each other within one step, at a relative speed above the sum of their diameters per step, do not collide.
// The ends of a spring shorter than the sum of their radii do not collide: the spring holds them in each other.
// Cost: `npm run bench -- circles --peers`, which also measures the same scene in plain JavaScript.

import { namedResource } from '../memory/resource.ts';
import { nameSystem } from '../world/name-system.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { activateContacts, contactTable } from './contact-table.ts';
import { beginImpacts } from './impact-list.ts';
import { collisionKernels } from './kernels.ts';
import { retakeContacts } from './retake-contacts.ts';
import { clampToSegments } from './segment-walls.ts';

const contactsEnabled = namedResource('contacts enabled', (world) => {
  activateContacts(world);
  return true;
});

/** System of the `collide` phase. It acts on bodies with Mass and Collider; bodies without Mass are immovable. */
export const collideBodies: LocalSystem = {
  name: 'collide bodies',
  readsOfOthers: ['Mass', 'Collider.radius', 'Collider.restitution', 'Collider.friction'],
  run(world, _spans, dt) {
    const { internal, lastId, integrator } = world;
    const kernels = collisionKernels(world);
    contactsEnabled(world);
    kernels.beginContacts();
    kernels.findPairs(internal.sweptRows, world.dimensions);
    kernels.sortContacts(lastId);
    if (internal.counts.Spring > 0 && internal.springTable !== undefined)
      kernels.omitLinked(internal.springTable(world));
    const confined = world.dimensions === 2 && internal.counts.SegmentWall > 0;
    const lag = (integrator.velocityLag ?? 0) * dt;
    beginImpacts(world);
    kernels.respondToImpacts(dt, lag, lastId);
    retakeContacts(world, dt);
    kernels.settleContacts(dt, lag, confined ? 1 : 0);
    contactTable(world).isResolved = true;
    if (confined) clampToSegments(world);
  },
};

/** System of the `begin` phase: enables contacts and clears the wall contacts of the last step. */
export const enableContacts = /* @__PURE__ */ nameSystem('enable contacts', (world: PhysicsWorld) => {
  contactsEnabled(world);
  contactTable(world).isResolved = false;
  collisionKernels(world).beginWallContacts();
});
