import { scanSprings } from '../forces/support/spring-table.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { constraintTable } from './constraint-table.ts';
import { constraintKernels } from './kernels.ts';

/**
 * Largest |d - L|/L of all springs at least as stiff as `stiffness`, N/m: how far from inextensible the world is. Slack
 * cords and springs without length do not count.
 * @throws PhysicsError E_DESTROYED
 */
export function maxStrain(world: PhysicsWorld, stiffness = 0): number {
  const { at } = constraintTable(world);
  if (world.internal.counts.Spring === 0) return 0;
  scanSprings(world);
  return constraintKernels(world).maxStrain(at, stiffness);
}

/** The root of the mean square of the same, over the springs that count. @throws PhysicsError E_DESTROYED */
export function rmsStrain(world: PhysicsWorld, stiffness = 0): number {
  const { at } = constraintTable(world);
  if (world.internal.counts.Spring === 0) return 0;
  scanSprings(world);
  return constraintKernels(world).rmsStrain(at, stiffness);
}
