import { checkChoice } from '../../errors/validate.ts';

/** @throws PhysicsError E_RANGE */
export function checkFrame(value: unknown, field: string): 'world' | 'body' {
  return checkChoice(value, field, ['world', 'body']);
}
