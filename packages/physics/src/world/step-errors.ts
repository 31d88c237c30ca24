// Collects the errors of a step and throws them at its end: exceptions of user code, and faults if the world's
// `onFault` is 'throw'.
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from './types.ts';

/** Clears the faults of the previous step. */
export function clearStepErrors({ internal }: PhysicsWorld): void {
  internal.stepFaults.length = 0;
}

/**
 * @throws AggregateError of all errors of the step, if there are any
 */
export function throwStepErrors(world: PhysicsWorld): void {
  const { internal, tick, onFault } = world;
  if (internal.thrownCount === 0 && internal.stepFaults.length === 0) return;
  const faults = onFault === 'throw' ? internal.stepFaults : [];
  const count = internal.thrownCount + faults.length;
  if (count === 0) return;
  const errors = internal.thrown.splice(0);
  internal.thrownCount = 0;
  for (const { code, entity, field, value, step, phase, hint } of faults) {
    const problem = `${field} of body ${entity} was ${value} ${phase === 'begin' ? 'before' : 'in'} step ${step}.`;
    errors.push(new PhysicsError(code, problem, { entity, field, value, hint }));
  }
  const messages = errors.slice(0, 3).map(String).join('; ');
  throw new AggregateError(errors, `${count} error(s) during step ${tick}: ${messages}${count > 3 ? '; …' : ''}`);
}
