import { PhysicsError } from '../faults/physics-error';
import type { PhysicsWorld } from '../world';

/** @throws PhysicsError E_DESTROYED, or E_TYPE for something that is no world */
export function assertUsable(world: PhysicsWorld): void {
  if (world?.internal === undefined) {
    throw new PhysicsError('E_TYPE', 'the first argument must be a world made by createPhysicsWorld.');
  }
  if (world.state === 'destroyed') throw new PhysicsError('E_DESTROYED', 'this world was destroyed.');
}
