import { PhysicsError } from '../../errors/physics-error.ts';
import type { Vector } from '../../errors/validate.ts';

/** A vector of length 1 in the same direction. @throws PhysicsError E_RANGE when there is none */
export function unit(vector: Vector, field: string): Vector {
  const length = Math.sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
  if (length > 1e-12) return { x: vector.x / length, y: vector.y / length, z: vector.z / length };
  throw new PhysicsError('E_RANGE', `${field} has no direction.`, {
    field,
    value: vector,
    hint: 'Give a vector that is not zero.',
  });
}
