// What a world of rigid bodies cannot contain, refused before a step.
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** @throws PhysicsError E_RANGE, which refuses the step */
export function refuseUnsupported(world: PhysicsWorld): void {
  if (world.dimensions === 3) {
    throw new PhysicsError('E_RANGE', 'rigid bodies are of two dimensions, and this world has three.', {
      field: 'dimensions',
      hint: 'Make the world with `dimensions: 2`, or take the preset `particleContacts`, whose balls collide in 3D.',
    });
  }
}
