// What a world of rigid bodies cannot contain, refused before a step.
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Wall components, which the systems of particle contacts read. */
const WALLS = ['SegmentWall', 'PlaneWall'] as const;

/** @throws PhysicsError E_RANGE, which refuses the step */
export function refuseUnsupported(world: PhysicsWorld): void {
  const { dimensions, internal, phases } = world;
  if (dimensions === 3) {
    throw new PhysicsError('E_RANGE', 'rigid bodies are of two dimensions, and this world has three.', {
      field: 'dimensions',
      hint: 'Make the world with `dimensions: 2`, or take the preset `particleContacts`, whose balls collide in 3D.',
    });
  }
  for (const name of WALLS) {
    if (internal.counts[name] > 0) throw wallError(name);
  }
  for (const system of phases.walls) {
    if (typeof system !== 'function' && system.role === 'box') throw wallError('boxWalls');
  }
}

function wallError(name: string): PhysicsError {
  return new PhysicsError('E_RANGE', `${name} does not hold rigid bodies.`, {
    field: name,
    hint: 'Make the wall a body without mass: spawn(world, { position, collider: { shape: segment(a, b) } }) or a box.',
  });
}
