import { maxStrain, type PhysicsWorld, rmsStrain } from '@principia/physics';
import type { Stretch } from './scene.ts';

/** A stiffness, N/m, that only inextensible threads reach: of what gives by design, the stretch says nothing. */
const INEXTENSIBLE = 1e29;

/** Of the inextensible threads of a scene. */
export function threadStretch(world: PhysicsWorld): Stretch {
  return { worst: maxStrain(world, INEXTENSIBLE), rms: rmsStrain(world, INEXTENSIBLE) };
}
