import { checkChoice } from '../../errors/validate.ts';

/** What a force may be proportional to. @throws PhysicsError E_RANGE */
export function checkCoupling(value: unknown, field: string): 'Mass' | 'Charge' {
  return checkChoice(value, field, ['Mass', 'Charge']);
}
