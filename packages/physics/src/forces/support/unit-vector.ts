import { PhysicsError } from '../../errors/physics-error.ts';
import type { Vector } from '../../errors/validate.ts';

/** Returns the vector of length 1 in the same direction. @throws PhysicsError E_RANGE for a zero vector */
export function unit(vector: Vector, field: string): Vector {
  const length = Math.sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
  if (length > 1e-12) return { x: vector.x / length, y: vector.y / length, z: vector.z / length };
  throw new PhysicsError('E_RANGE', `${field} has no direction: its length is ${length}.`, {
    field,
    value: vector,
    hint: 'Give a vector longer than 1e-12.',
  });
}
