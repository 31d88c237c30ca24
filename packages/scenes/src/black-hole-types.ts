/** A hole and its orbit. */
export interface Hole {
  /** Centre of the hole, or of its orbit. */
  readonly x: number;
  readonly y: number;
  /** Radius of the horizon. */
  readonly radius: number;
  /** Radius of the orbit; zero for a fixed hole. */
  readonly orbit: number;
  /** Angular velocity on the orbit, rad/s; positive is anticlockwise. */
  readonly rate: number;
  /** Angle on the orbit at time zero. */
  readonly phase: number;
}
