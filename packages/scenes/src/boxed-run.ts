import type { SceneRun } from './scene.ts';

/** Round bodies in a box, made; peers need to know the box. */
export interface BoxedRun extends SceneRun {
  /** The box reaches from the origin to here, m; z is 0 in 2D. */
  readonly far: { readonly x: number; readonly y: number; readonly z: number };
  /** Acceleration of free fall along -y, m/s². */
  readonly gravity: number;
  /** Restitution and friction of the walls. */
  readonly restitution: number;
  readonly friction: number;
}
