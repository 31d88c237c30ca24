import type { VectorInput } from '../errors/validate.ts';
import { describeJoint, type EveryJointOptions, type JointInput } from './joint-input.ts';

/** Options of `pulley`. */
export interface PulleyOptions extends EveryJointOptions {
  /** The first body, by id. */
  readonly a: number;
  /** Where the rope leaves the wheel above a, m, in world coordinates; it does not move with anything. */
  readonly pulleyA: VectorInput;
  /** Where it leaves the wheel above b. */
  readonly pulleyB: VectorInput;
  /** Where it is tied to a, m, in world coordinates; default its centre. */
  readonly anchorA?: VectorInput;
  /** Where it is tied to b, m, in world coordinates; default its centre. */
  readonly anchorB?: VectorInput;
  /** Metres of rope at a for one at b, as of a block and tackle; default 1. */
  readonly ratio?: number;
  /** Length at a and `ratio` times the length at b, m; default as it is now. */
  readonly length?: number;
}

/**
 * A rope over two wheels. It pulls both bodies, and may be slack. `jointForce` and `breakForce` are the force on b, which is
 * `ratio` times that on a. A body
 * that is drawn up to its wheel rests there, and the force is then what holds it.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function pulley(options: PulleyOptions): JointInput {
  return describeJoint('pulley', options, ['pulleyA', 'pulleyB', 'anchorA', 'anchorB', 'ratio', 'length']);
}
