import type { Axes } from '../laws/vector-algebra.ts';
import type { AxisAddresses } from '../memory/columns.ts';

/** An axis-aligned box; a coordinate beyond `FAR` is no wall. */
export interface Box {
  readonly low: Readonly<AxisAddresses>;
  readonly high: Readonly<AxisAddresses>;
  readonly restitution: number;
  /** Negative where the bodies' own friction counts. */
  readonly friction: number;
}

/** What a step loop does besides moving bodies. */
export interface StepFeatures {
  /** Positions before the step go to `world.previous`. */
  readonly savesPose: boolean;
  /** Velocities before the step go to the scratch columns, for walls that are not part of the loop. */
  readonly savesVelocity: boolean;
  readonly hasTorque: boolean;
  readonly box: Box | undefined;
  /** Address of the list of bodies at walls. */
  readonly list: number;
  /** Columns that the scheme keeps from step to step. */
  readonly memory: readonly Readonly<AxisAddresses>[];
}

/** Where a step leads. */
export interface Result {
  readonly position: Axes;
  readonly velocity: Axes;
  readonly memory: readonly Axes[];
}
