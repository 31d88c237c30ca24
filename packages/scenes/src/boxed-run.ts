import type { SceneRun } from './scene.ts';

/** A run with round bodies in a box, with the properties of the box that peers need. */
export interface BoxedRun extends SceneRun {
  /** Corner of the box opposite to the origin, m; z is 0 in 2D. */
  readonly far: { readonly x: number; readonly y: number; readonly z: number };
  /** Acceleration of free fall along -y, m/s². */
  readonly gravity: number;
  /** Restitution and friction of the walls. */
  readonly restitution: number;
  readonly friction: number;
}
