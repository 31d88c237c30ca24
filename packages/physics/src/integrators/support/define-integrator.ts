import { checkFunction } from '../../errors/validate.ts';
import { recordScheme, type SchemeFunction, type SchemeOptions } from '../../laws/scheme.ts';
import type { Integrator, Scheme } from '../../world/types.ts';

type Facts = Omit<Integrator, 'scheme' | 'advance'>;

/**
 * An integrator of fixed stages, written as expressions: it becomes one loop with the laws of a world. `index.ts` exports
 * it as `defineIntegrator`.
 * @param facts what is known of it
 * @param step from the state at the start to the state at the end; called once, now, with symbols
 * @throws PhysicsError E_TYPE for what is no function, or for what a method of a symbol does not take
 */
export function defineCheckedIntegrator(facts: Facts, step: SchemeFunction, options?: SchemeOptions): Integrator {
  checkFunction(step, 'defineIntegrator: step');
  return { ...facts, scheme: recordScheme(step, options) };
}

/**
 * The same for an integrator of this package: its step is called when a world first uses it, so that a page does not wait
 * for schemes that it does not use.
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
