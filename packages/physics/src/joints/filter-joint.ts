import { describeJoint, type JointInput } from './joint-input.ts';

/**
 * Keeps two bodies from colliding with each other, and does nothing else.
 * @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN
 */
export function filterJoint(options: { readonly a: number; readonly b: number }): JointInput {
  return describeJoint('filterJoint', options, []);
}
