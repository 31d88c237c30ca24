import { PhysicsError } from '../faults/physics-error';

/** What a force may be proportional to. @throws PhysicsError E_RANGE */
export function checkCoupling(value: unknown, field: string): 'Mass' | 'Charge' {
  if (value === 'Mass' || value === 'Charge') return value;
  throw new PhysicsError('E_RANGE', `${field} must be 'Mass' or 'Charge', got ${String(value)}.`, { field, value });
}
