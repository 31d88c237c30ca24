// Collisions of round bodies: discs in 2D, balls in 3D.
//
//   broad phase   uniform grid of hashed cells                              kernels/particle-contacts/grid.ts, pairs.ts
//   order         ascending (a, b)                                          kernels/particle-contacts/order.ts
//   impacts       restitution and friction at the instant of touching       kernels/particle-contacts/impacts.ts
//   rest          sequential impulses, started from the last step's         kernels/particle-contacts/resting-contacts.ts
//   overlap       displacement at bounded speed                             kernels/particle-contacts/position-correction.ts
//                 the last two on several contacts at once                  kernels/particle-contacts/wide-contacts.ts
//
// A contact's restitution is the larger of the two bodies', its friction coefficient the geometric mean, as for walls.
// Bodies are looked at where they are when the step ends: two that pass through each other within one step, which takes
// a relative speed above the sum of their diameters a step, do not collide. Cost: `npm run bench -- circles --peers`, beside the same in plain JavaScript.

import { resource } from '../memory/resource.ts';
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import { activateContacts } from './contact-table.ts';
import { collisionKernels } from './kernels.ts';
import { confineToSegments } from './segment-walls.ts';

const opened = resource((world) => {
  activateContacts(world);
  return true;
});

/** System of the `collide` phase. Acts on bodies with Mass and Collider; bodies without Mass do not give way. */
export const collideBodies: LocalSystem = {
  name: 'collide bodies',
  run(world, _spans, dt) {
    const { internal, lastId, integrator } = world;
    const kernels = collisionKernels(world);
    opened(world);
    kernels.beginContacts();
    kernels.findPairs(internal.sweptRows, internal.bodyList.count, world.dimensions);
    kernels.sortContacts(lastId);
    const confined = world.dimensions === 2 && internal.counts.SegmentWall > 0;
    kernels.respond(dt, (integrator.velocityLag ?? 0) * dt, lastId, confined ? 1 : 0);
    if (confined) confineToSegments(world);
  },
};

/** System of the `begin` phase: forgets the last step's contacts with walls. */
export function enableContacts(world: PhysicsWorld): void {
  opened(world);
  collisionKernels(world).beginWallContacts();
}
