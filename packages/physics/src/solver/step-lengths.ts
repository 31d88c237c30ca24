// Steps of different lengths: what contacts and joints keep from one step for the next. kernels/solver/2d/scale-impulses.ts
// says why.
import { rigidKernels } from '../collision/kernels.ts';
import { jointTable } from '../joints/joint-table.ts';
import { RigidTableNumber as Value } from '../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { rigidTable } from './rigid-table.ts';

/**
 * Factor of the recent length of sub-steps in each step that is shorter. The stiffness of contacts follows this length: slowly, so
 * that a tower follows it.
 */
const DECAY = 0.97;

/** Joints keep the whole impulses of a short step, and so may grow by no more than this in the next one. */
const MAX_JOINT_GROWTH = 8;

/** Prepares the world for sub-steps of h seconds. */
export function beginSubsteps(world: PhysicsWorld, h: number): void {
  const { at, numbers } = rigidTable(world);
  const before = numbers[Value.h];
  if (before > 0 && before !== h) scaleImpulses(world, at, h / before);
  const recent = Math.max(h, DECAY * numbers[Value.recentLength]);
  numbers[Value.h] = h;
  numbers[Value.recentLength] = recent;
  numbers[Value.impulseWeight] = h / recent;
}

function scaleImpulses(world: PhysicsWorld, at: number, factor: number): void {
  const kernels = rigidKernels(world);
  kernels.scaleContactImpulses(at, factor);
  if (world.internal.counts.Joint === 0) return;
  kernels.scaleJointImpulses(jointTable(world).at, Math.min(factor, MAX_JOINT_GROWTH));
}
