import { describeJoint, type JointInput } from './joint-input.ts';

/** Options of `filterJoint`. */
export interface FilterJointOptions {
  /** The first body, by id. */
  readonly a: number;
  /** The second body, by id. */
  readonly b: number;
}

/**
 * Keeps two bodies from colliding with each other, and does nothing else.
 * @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN
 */
export function filterJoint(options: FilterJointOptions): JointInput {
  return describeJoint('filterJoint', options, []);
}
