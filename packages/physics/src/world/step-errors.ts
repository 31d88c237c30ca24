// What went wrong in a step is collected while it runs and thrown when it has ended: exceptions of users' code, and faults
// where the world was asked to throw them.
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from './types.ts';

/** Forgets the faults of the step before. */
export function clearStepErrors({ internal }: PhysicsWorld): void {
  internal.stepFaults.length = 0;
}

/** @throws AggregateError of everything that the step collected, if that is anything */
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
  const said = errors.slice(0, 3).map(String).join('; ');
  throw new AggregateError(errors, `${count} error(s) during step ${tick}: ${said}${count > 3 ? '; …' : ''}`);
}
