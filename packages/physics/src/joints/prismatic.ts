import type { VectorInput } from '../errors/validate.ts';
import {
  describeJoint,
  type JointInput,
  type JointLimits,
  type JointMotor,
  type JointOptions,
  type JointSpring,
} from './joint-input.ts';

/** Options of `prismatic`. */
export interface PrismaticOptions extends JointOptions {
  /** Point of b that slides, m, in world coordinates. */
  readonly anchor: VectorInput;
  /** Direction in which it slides, in world coordinates; it turns with a. */
  readonly axis: VectorInput;
  /** Bounds of the distance from where b is now, m. Default none. */
  readonly limits?: JointLimits;
  /** Pulls b back to where it is now. Default none. */
  readonly spring?: JointSpring;
  /** Speed in m/s, largest force in N. Default none. */
  readonly motor?: JointMotor;
}

/**
 * A slider: b moves along a straight line of a and does not turn against it.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function prismatic(options: PrismaticOptions): JointInput {
  return describeJoint('prismatic', options, ['anchor', 'axis', 'limits', 'spring', 'motor']);
}
