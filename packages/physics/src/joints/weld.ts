import type { VectorInput } from '../errors/validate.ts';
import { describeJoint, type JointInput, type JointOptions, type JointSpring } from './joint-input.ts';

/** Options of `weld`. */
export interface WeldOptions extends JointOptions {
  /** Point at which the bodies are joined, m, in world coordinates. */
  readonly anchor: VectorInput;
  /** With a spring the joint bends; without one the angle is fixed. Default none. */
  readonly spring?: JointSpring;
}

/**
 * Joins two bodies in their present poses.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function weld(options: WeldOptions): JointInput {
  return describeJoint('weld', options, ['anchor', 'spring']);
}
