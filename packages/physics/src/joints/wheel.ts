import type { VectorInput } from '../errors/validate.ts';
import {
  describeJoint,
  type JointInput,
  type JointLimits,
  type JointMotor,
  type JointOptions,
  type JointSpring,
} from './joint-input.ts';

/** Options of `wheel`. */
export interface WheelOptions extends JointOptions {
  /** Axle of the wheel b, m, in world coordinates. */
  readonly anchor: VectorInput;
  /** Direction of the suspension, in world coordinates; it turns with a. Default upwards. */
  readonly axis?: VectorInput;
  /** Suspension; default 1 Hz with a damping ratio of 0.7. */
  readonly spring?: JointSpring;
  /** Bounds of the travel of the suspension, m. Default none. */
  readonly limits?: JointLimits;
  /** Speed of the wheel in rad/s, largest torque in N m. Default none. */
  readonly motor?: JointMotor;
}

/** Source: b2DefaultWheelJointDef of Box2D 3. */
const SUSPENSION: JointSpring = { hertz: 1, dampingRatio: 0.7 };

/**
 * A wheel b on a suspension of a: it moves along the axis and turns freely.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function wheel(options: WheelOptions): JointInput {
  const filled = { spring: SUSPENSION, axis: { y: 1 }, ...options };
  return describeJoint('wheel', filled, ['anchor', 'axis', 'limits', 'spring', 'motor']);
}
