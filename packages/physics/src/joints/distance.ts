import type { VectorInput } from '../errors/validate.ts';
import {
  type DistanceSpring,
  describeJoint,
  type JointInput,
  type JointLimits,
  type JointMotor,
  type JointOptions,
} from './joint-input.ts';

/** Options of `distance`. */
export interface DistanceOptions extends JointOptions {
  /** Point of a, m, in world coordinates; default its centre, and where b is held to the world the point of b. */
  readonly anchorA?: VectorInput;
  /** Point of b, m, in world coordinates; default its centre. */
  readonly anchorB?: VectorInput;
  /** Length, m; default the distance of the points now. */
  readonly length?: number;
  /** With a spring the length is that at rest; without spring, limits and motor it is fixed. Default none. */
  readonly spring?: DistanceSpring;
  /** Bounds of the distance, m: `{ upper: 2 }` is a rope. Default none, with a motor that of no length. */
  readonly limits?: JointLimits;
  /** Speed at which it grows, m/s, and largest force, N. Default none. */
  readonly motor?: JointMotor;
}

/**
 * A rod, a spring or a rope between two points of two bodies.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function distance(options: DistanceOptions): JointInput {
  const isWinch = options?.motor !== undefined && options.spring === undefined && options.limits === undefined;
  const free = isWinch ? { ...options, limits: {} } : options;
  return describeJoint('distance', free, ['anchorA', 'anchorB', 'length', 'spring', 'limits', 'motor']);
}
