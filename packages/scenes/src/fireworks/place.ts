// Points in the sky.

/** A point or vector, m or m/s. */
export interface Point3 {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** Reads the position of expired particle `i` of an emitter into `out`. */
export function readPosition(states: Float64Array, i: number, out: { x: number; y: number; z: number }): Point3 {
  out.x = states[6 * i];
  out.y = states[6 * i + 1];
  out.z = states[6 * i + 2];
  return out;
}

export const ORIGIN: Point3 = { x: 0, y: 0, z: 0 };
