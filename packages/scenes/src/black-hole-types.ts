/** A hole, and the circle its centre runs on if it moves. */
export interface Hole {
  /** Centre of the hole, or of its circle. */
  readonly x: number;
  readonly y: number;
  /** Radius of the horizon. */
  readonly radius: number;
  /** Radius of the circle; zero for a hole that rests. */
  readonly orbit: number;
  /** Angular velocity on the circle, rad/s; positive turns left. */
  readonly rate: number;
  /** Angle on the circle at time zero. */
  readonly phase: number;
}
