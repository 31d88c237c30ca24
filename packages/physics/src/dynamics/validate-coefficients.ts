// The coefficients through which one body acts on others: a mass that is not a number would reach every body that it pulls.
import { COMPONENTS } from '../components/all.ts';
import { reportFault } from '../errors/report-fault.ts';
import type { PhysicsWorld } from '../world/types.ts';

const SHARED = [
  ['Mass', 'value'],
  ['Charge', 'value'],
  ['Collider', 'radius'],
  ['Collider', 'restitution'],
  ['Collider', 'friction'],
] as const;

/**
 * Reports coefficients out of the bounds of their component, and sets them to zero, which is that of a body without the
 * component. Where no force, integrator or contact joins bodies there is nothing to do: a bad body is alone then.
 */
export function validateCoefficients(world: PhysicsWorld): void {
  const { forcesLocal } = world.internal.plan as { forcesLocal: boolean };
  if (forcesLocal && world.integrator.wholeWorld !== true && world.phases.collide.length === 0) return;
  const { counts, bodyList } = world.internal;
  const { ids, count } = bodyList;
  for (const [name, field] of SHARED) {
    if (counts[name] === 0) continue;
    const column = (world.components[name] as Readonly<Record<string, { [row: number]: number }>>)[field];
    const { bounds } = (COMPONENTS[name].fields as Readonly<Record<string, { bounds: { max?: number } }>>)[field];
    const { max = Number.MAX_VALUE } = bounds;
    for (let i = 0; i < count; i++) {
      const value = column[ids[i]];
      // Zero is that of the absent; a mass of zero is that of a body that nothing moves.
      if (value <= max && value >= -max) continue;
      const code = Number.isFinite(value) ? 'E_RANGE' : 'E_NONFINITE';
      reportFault(world, { code, entity: ids[i], field: `${name}.${field}`, value, phase: 'begin' });
      column[ids[i]] = 0;
    }
  }
}
