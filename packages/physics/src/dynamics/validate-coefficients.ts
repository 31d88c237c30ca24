// Validates the coefficients by which a body acts on others: a NaN mass would spread to every body that it attracts.
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
 * Reports coefficients outside the bounds of their component and sets them to zero, the value of an absent component.
 * Does nothing if no force, integrator or contact couples bodies, because an invalid body cannot affect others then.
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
      // Zero is the value of an absent component; a body of mass zero is immovable.
      if (value <= max && value >= -max) continue;
      const code = Number.isFinite(value) ? 'E_RANGE' : 'E_NONFINITE';
      reportFault(world, { code, entity: ids[i], field: `${name}.${field}`, value, phase: 'begin' });
      column[ids[i]] = 0;
    }
  }
}
