import type { VectorInput } from '../errors/validate.ts';
import { describeJoint, type JointInput, type JointOptions } from './joint-input.ts';

export interface PulleyOptions extends JointOptions {
  readonly a: number;
  /** Where the rope leaves the two wheels, m, in world coordinates. */
  readonly pulleyA: VectorInput;
  readonly pulleyB: VectorInput;
  /** Where it is tied to a and b, m, in world coordinates; default their centres. */
  readonly anchorA?: VectorInput;
  /** Default the centre of b. */
  readonly anchorB?: VectorInput;
  /** Metres of rope at a for one at b, as of a block and tackle; default 1. */
  readonly ratio?: number;
  /** Length at a and `ratio` times the length at b, m; default as it is now. */
  readonly length?: number;
}

/**
 * A rope over two wheels. It pulls both bodies, and may be slack.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function pulley(options: PulleyOptions): JointInput {
  return describeJoint('pulley', options, ['pulleyA', 'pulleyB', 'anchorA', 'anchorB', 'ratio', 'length']);
}
