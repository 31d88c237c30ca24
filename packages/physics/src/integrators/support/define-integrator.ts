import { checkFunction } from '../../errors/validate.ts';
import { recordScheme, type SchemeFunction, type SchemeOptions } from '../../laws/scheme.ts';
import type { Integrator } from '../../world/types.ts';

/**
 * An integrator of fixed stages, written as expressions: it becomes one loop with the laws of a world.
 * @param facts what is known of it
 * @param step from the state at the start to the state at the end; called once, now, with symbols
 * @throws PhysicsError E_TYPE for what is no function, or for what a method of a symbol does not take
 */
export function defineIntegrator(
  facts: Omit<Integrator, 'scheme' | 'advance'>,
  step: SchemeFunction,
  options?: SchemeOptions,
): Integrator {
  checkFunction(step, 'defineIntegrator: step');
  return { ...facts, scheme: recordScheme(step, options) };
}
