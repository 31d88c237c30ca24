// What a system of the `walls` phase tells the loop of the step.
import type { LocalSystem, PhysicsWorld } from '../world/types.ts';
import type { Box } from './step-features.ts';

/** Walls that the loop can test: a system of the `walls` phase with a box. */
export interface BoxSystem extends LocalSystem {
  readonly box: Box;
  /** Allocates its memory. */
  prepare(world: PhysicsWorld): unknown;
  /**
   * Bounces the bodies of a list: see `WallTest`. Returns whether all velocities are in range.
   * @param words the list, whose address is `list`
   * @param savesVelocity the velocities at the start of the step are in columns, and not in the list
   */
  bounceListed(world: PhysicsWorld, words: Uint32Array, list: number, dt: number, savesVelocity: boolean): boolean;
}
