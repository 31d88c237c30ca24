import { checkFunction } from '../../errors/validate.ts';
import { lastStepOfBody } from '../../laws/last-step.ts';
import { recordScheme, type SchemeFunction, type SchemeOptions } from '../../laws/scheme.ts';
import type { Integrator, Scheme } from '../../world/types.ts';

type Facts = Omit<Integrator, 'scheme' | 'advance'>;

/**
 * Defines an integrator of fixed stages by expressions, which are fused with the laws of a world into one loop.
 * `index.ts` exports it as `defineIntegrator`.
 * @param facts the properties of the integrator
 * @param step maps the state at the start to the state at the end; called once, now, with symbols
 * @throws PhysicsError E_TYPE for a value that is no function, or for an invalid argument of a symbol's method
 */
export function defineCheckedIntegrator(facts: Facts, step: SchemeFunction, options?: SchemeOptions): Integrator {
  checkFunction(step, 'defineIntegrator: step');
  const scheme = recordScheme(step, options);
  if (scheme.memory.length === 0) return { ...facts, scheme };
  // Three columns for each vector, and one that says whose they are.
  const columns = facts.columns ?? 3 * scheme.memory.length + 1;
  const structure = `${scheme.structure};of bodies`;
  return { ...facts, columns, scheme: { ...scheme, structure, lastStep: lastStepOfBody } };
}

/**
 * Defines a built-in integrator; its step is recorded on first use, so that a page does not pay for unused schemes.
 */
export function defineIntegrator(facts: Facts, step: SchemeFunction, options?: SchemeOptions): Integrator {
  let recorded: Scheme | undefined;
  return {
    ...facts,
    get scheme() {
      recorded ??= recordScheme(step, options);
      return recorded;
    },
  };
}
