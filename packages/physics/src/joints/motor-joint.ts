import type { VectorInput } from '../errors/validate.ts';
import {
  describeJoint,
  type EveryJointOptions,
  type JointInput,
  type JointOptions,
  type JointSpring,
} from './joint-input.ts';

/** Options of `motorJoint`. */
export interface MotorJointOptions extends JointOptions {
  /** Point of b that is driven, m, in world coordinates; default its centre. */
  readonly anchor?: VectorInput;
  /** Where it is driven to, m, in world coordinates; default where it is now. It moves with a. */
  readonly target?: VectorInput;
  /** Angle to which b is turned against a, from how they are now, rad; default 0. */
  readonly turn?: number;
  /** How b approaches; default 1 Hz, critically damped. With `hertz: 0` b is stopped against a wherever it is. */
  readonly spring?: JointSpring;
  /** Largest force, N. */
  readonly maxForce: number;
  /** Largest torque, N m. */
  readonly maxTorque: number;
  /** With `hertz: 0`, the speed at which b turns against a, rad/s; default 0. */
  readonly angularSpeed?: number;
}

/**
 * Drives b to a pose in the frame of a, with a limited force and torque: a platform, a character, or, with `hertz: 0`, the
 * friction of a floor that is seen from above.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function motorJoint(options: MotorJointOptions): JointInput {
  const filled = { spring: { hertz: 1 }, ...options };
  const names = ['anchor', 'target', 'turn', 'spring', 'maxForce', 'maxTorque', 'angularSpeed'] as const;
  return describeJoint('motorJoint', filled, names);
}

/** Options of `mouseJoint`. */
export interface MouseJointOptions extends EveryJointOptions {
  /** Point of b that is pulled, m, in world coordinates; default its centre. */
  readonly anchor?: VectorInput;
  /** Where it is pulled to, m, in world coordinates. The columns `Joint.ax` and `Joint.ay` move it. */
  readonly target: VectorInput;
  /**
   * How b approaches; default 5 Hz with a damping ratio of 0.7. The stiffness is that for the mass m of b alone: under a force F, also the weight
   * of what hangs on b, its point stays F/(m (2π hertz)²) from the target.
   */
  readonly spring?: JointSpring;
  /** Largest force, N. */
  readonly maxForce: number;
}

/**
 * Pulls a point of a body to a target, such as a pointer, without fixing its angle: `motorJoint` to the world without a torque.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function mouseJoint(options: MouseJointOptions): JointInput {
  const filled = { spring: { hertz: 5, dampingRatio: 0.7 }, ...options };
  return describeJoint('mouseJoint', filled, ['anchor', 'target', 'spring', 'maxForce']);
}
