import type { VectorInput } from '../errors/validate.ts';
import {
  describeJoint,
  type JointInput,
  type JointLimits,
  type JointMotor,
  type JointOptions,
  type JointSpring,
} from './joint-input.ts';

/** Options of `revolute`. */
export interface RevoluteOptions extends JointOptions {
  /** Point about which the bodies turn, m, in world coordinates. */
  readonly anchor: VectorInput;
  /** Bounds of the angle of b from a, rad, which is 0 as the bodies are now. Default none. */
  readonly limits?: JointLimits;
  /** Turns the bodies back to the angle 0. Default none. */
  readonly spring?: JointSpring;
  /** Speed in rad/s, largest torque in N m. Default none. */
  readonly motor?: JointMotor;
}

/**
 * A hinge: the two bodies share a point and turn about it. It has no friction, so that limbs of a ragdoll swing on for long and
 * keep it awake: `motor: { speed: 0, max }` is friction of up to `max`, a tenth of the weight times the arm for example, with
 * which they come to rest and sleep.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function revolute(options: RevoluteOptions): JointInput {
  return describeJoint('revolute', options, ['anchor', 'limits', 'spring', 'motor']);
}
