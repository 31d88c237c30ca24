import { scanSprings } from '../forces/support/spring-table.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { constraintTable } from './constraint-table.ts';
import { constraintKernels } from './kernels.ts';

/**
 * Returns the largest strain |d - L|/L of all springs with at least `stiffness`, N/m. Slack tension-only springs and
 * springs without length are excluded.
 * @throws PhysicsError E_DESTROYED
 */
export function maxStrain(world: PhysicsWorld, stiffness = 0): number {
  const { at } = constraintTable(world);
  if (world.internal.counts.Spring === 0) return 0;
  scanSprings(world);
  return constraintKernels(world).maxStrain(at, stiffness);
}

/** Returns the root mean square strain of the same springs. @throws PhysicsError E_DESTROYED */
export function rmsStrain(world: PhysicsWorld, stiffness = 0): number {
  const { at } = constraintTable(world);
  if (world.internal.counts.Spring === 0) return 0;
  scanSprings(world);
  return constraintKernels(world).rmsStrain(at, stiffness);
}
