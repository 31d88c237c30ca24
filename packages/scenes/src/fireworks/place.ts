// Places in the sky.

/** Numbers that bursts are asked with, m or m/s. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** The place of ending number `i` of an emitter, written into `out`. */
export function readPlace(states: Float64Array, i: number, out: { x: number; y: number; z: number }): Place {
  out.x = states[6 * i];
  out.y = states[6 * i + 1];
  out.z = states[6 * i + 2];
  return out;
}

export const STILL: Place = { x: 0, y: 0, z: 0 };
