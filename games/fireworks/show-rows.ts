/** Shows as rows of numbers, which are quick to read and to write. */
import type { Cue } from './sim.ts';

/** Indices of the kinds of shells that a show written by hand uses. */
export const [PEONY, WILLOW, RING, CRACKLE, PALM, CHARGED, CHAIN, LANTERN] = [0, 1, 2, 3, 4, 5, 6, 7];
/** Indices of the colours. */
export const [RED, ORANGE, YELLOW, GREEN, BLUE, VIOLET, SILVER, GOLD] = [0, 1, 2, 3, 4, 5, 6, 7];

/** A shell: seconds from the start of the show to its launch, the point of its burst, m, its kind, colour and power. */
export type ShowRow = readonly [
  seconds: number,
  x: number,
  y: number,
  z: number,
  kind: number,
  color: number,
  power: number,
];

export function cuesOf(rows: readonly ShowRow[]): readonly Cue[] {
  return rows.map(([seconds, x, y, z, kind, color, power]) => ({
    tick: Math.round(60 * seconds),
    x,
    y,
    z,
    kind,
    color,
    power,
  }));
}
