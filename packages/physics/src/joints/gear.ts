import type { VectorInput } from '../errors/validate.ts';
import { describeJoint, type EveryJointOptions, type JointInput } from './joint-input.ts';

/** Options of `gear`. */
export interface GearOptions extends EveryJointOptions {
  /** The first body, by id: the pinion of a rack. */
  readonly a: number;
  /** Angle by which b turns for each radian of a: negative for two wheels whose teeth mesh. Of a rack, metres. */
  readonly ratio: number;
  /**
   * Direction in the world along which b moves, in place of turning: b is a rack, and a its pinion. Default none: b
   * turns.
   */
  readonly axis?: VectorInput;
}

/**
 * Couples the turns of two bodies, or the turn of a with the motion of b along an axis. What holds the bodies, such as two
 * joints `revolute`, is made beside it.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function gear(options: GearOptions): JointInput {
  return describeJoint('gear', options, ['ratio', 'axis']);
}
