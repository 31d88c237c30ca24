import type { Store } from '../laws/loop-source.ts';
import type { Axes } from '../laws/vector-algebra.ts';
import type { AxisAddresses } from '../memory/columns.ts';
import type { KeptColumns } from './scheme-memory.ts';

/** An axis-aligned box; a coordinate beyond `FAR` means no wall. */
export interface Box {
  readonly low: Readonly<AxisAddresses>;
  readonly high: Readonly<AxisAddresses>;
  readonly restitution: number;
  /** A negative value selects the bodies' own friction. */
  readonly friction: number;
}

/** What a step loop does in addition to moving bodies. */
export interface StepFeatures {
  /** Saves the positions before the step to `world.previous`. */
  readonly savesPose: boolean;
  /** Saves the velocities before the step to the scratch columns, for walls outside the loop. */
  readonly savesVelocity: boolean;
  readonly hasTorque: boolean;
  readonly box: Box | undefined;
  /** Address of the list of bodies at walls. */
  readonly list: number;
  /** Bodies near a wall are listed, too, and resting ones are left to the kernel, which records their contacts. */
  readonly recordsContacts: boolean;
  /** Columns that the scheme keeps between steps. */
  readonly memory: KeptColumns;
}

/** The state after a step. */
export interface Result {
  readonly position: Axes;
  readonly velocity: Axes;
  /** What the scheme keeps for the next step. */
  readonly kept: readonly Store[];
}
