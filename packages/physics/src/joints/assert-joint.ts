import { staleError } from '../ecs/entity-ref.ts';
import { assertUsable } from '../ecs/guards.ts';
import { isOpen } from '../ecs/rows.ts';
import { describe } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** @throws PhysicsError E_STALE when there is no joint with this id, E_DESTROYED */
export function assertJoint(world: PhysicsWorld, joint: number): void {
  assertUsable(world);
  if (!Number.isInteger(joint) || !isOpen(world, joint, 'Joint'))
    throw staleError(joint, `there is no joint ${describe(joint)} in this world.`);
}
