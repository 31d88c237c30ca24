/** The show that plays until the player fires. */
import type { Cue } from './sim.ts';

const [PEONY, WILLOW, RING, CRACKLE, PALM, CHARGED, CHAIN, LANTERN] = [0, 1, 2, 3, 4, 5, 6, 7];
const [RED, ORANGE, YELLOW, GREEN, BLUE, VIOLET, SILVER, GOLD] = [0, 1, 2, 3, 4, 5, 6, 7];

/** Seconds, x, y, z, kind, colour, power. */
const rows: readonly (readonly number[])[] = [
  // The first shells burst low, so that the page shows light within two seconds.
  [0, -13, 15, 3, RING, GOLD, 0.2],
  [0, 13, 15, -3, RING, SILVER, 0.2],
  [0, 0, 38, 0, PEONY, RED, 0.8],
  [0.9, -24, 32, -4, RING, SILVER, 0.4],
  [1, 24, 32, 4, RING, SILVER, 0.4],
  [2.2, -32, 42, 6, WILLOW, GOLD, 0.5],
  [2.6, 30, 40, -6, PEONY, BLUE, 0.6],
  [3.8, 4, 30, 0, PALM, GOLD, 0.5],
  [5, -16, 40, 3, CHARGED, VIOLET, 0.5],
  [5.6, 18, 44, -3, CRACKLE, GREEN, 0.4],
  [7, -36, 28, 0, PEONY, GREEN, 0.4],
  [7.3, -18, 34, 0, PEONY, YELLOW, 0.4],
  [7.6, 0, 40, 0, PEONY, ORANGE, 0.4],
  [7.9, 18, 34, 0, PEONY, RED, 0.4],
  [8.2, 36, 28, 0, PEONY, VIOLET, 0.4],
  [10, -26, 44, 5, PALM, SILVER, 0.7],
  [10.4, 26, 44, -5, PALM, GOLD, 0.7],
  [12, 0, 46, 0, WILLOW, GOLD, 1],
  [13.4, -34, 36, 0, RING, BLUE, 0.5],
  [13.6, 34, 36, 0, RING, RED, 0.5],
  [15, -10, 30, 0, CRACKLE, SILVER, 0.6],
  [15.2, 12, 36, 0, CHAIN, YELLOW, 0.5],
  [16, 0, 26, 0, LANTERN, ORANGE, 0.8],
  [17, 30, 42, -8, CHARGED, BLUE, 0.7],
  [17.5, -30, 40, 8, CHARGED, ORANGE, 0.7],
  [19, 0, 34, 0, PEONY, VIOLET, 1],
];

export const DEMO_SHOW: readonly Cue[] = rows.map(([seconds, x, y, z, kind, color, power]) => ({
  tick: Math.round(60 * seconds),
  x,
  y,
  z,
  kind,
  color,
  power,
}));
