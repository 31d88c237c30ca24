import { checkChoice } from '../../errors/validate.ts';

/** Checks the component that a force is proportional to. @throws PhysicsError E_RANGE */
export function checkCoupling(value: unknown, field: string): 'Mass' | 'Charge' {
  return checkChoice(value, field, ['Mass', 'Charge']);
}
