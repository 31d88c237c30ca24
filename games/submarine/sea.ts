/** The sea of a level: its bed, what lies on it, and its currents. Heights are negative below the surface, m. */
import { createRandom } from '@principia/physics';

/** Width of the sea and distance of two points of its bed, m. */
export const WIDTH = 560;
const SPACING = 14;
/** Where the ship waits at the surface, and how near one must come up, m. */
export const SHIP = { x: 50, reach: 28 } as const;

export interface Sea {
  /** Points of the bed from left to right: x and height in turn, m. */
  readonly bed: Float64Array;
  /** Crates on the bed: x and height in turn, m. */
  readonly crates: Float64Array;
  /** Largest depth that the hull stands, m. */
  readonly crushDepth: number;
  /** Speed of the currents, m/s. */
  readonly current: number;
}

/** The currents run in two bands, to the right above and to the left below, each with a smooth profile. */
const BANDS = [
  { depth: 38, half: 16, sign: 1 },
  { depth: 84, half: 18, sign: -1 },
] as const;

export function createSea(level: number, seed: number): Sea {
  const random = createRandom(seed, level);
  const count = Math.round(WIDTH / SPACING) + 1;
  const bed = new Float64Array(2 * count);
  const deepest = 70 + 14 * Math.min(level, 8);
  let height = -30;
  for (let i = 0; i < count; i++) {
    // The bed falls from the ship's bay to the deep, with hills that the seed gives.
    const slope = Math.min(1, i / 9);
    const wanted = -26 - slope * (deepest - 40) + random.uniform(-22, 22) * slope;
    height += 0.6 * (wanted - height);
    bed[2 * i] = i * SPACING;
    bed[2 * i + 1] = Math.max(-deepest, height);
  }
  const wantedCrates = Math.min(7, 2 + level);
  const crates = new Float64Array(2 * wantedCrates);
  for (let k = 0; k < wantedCrates; k++) {
    // Each lies in the lowest place of its own part of the bed.
    const first = Math.floor(8 + ((count - 10) * k) / wantedCrates);
    const last = Math.floor(8 + ((count - 10) * (k + 1)) / wantedCrates) - 1;
    let lowest = first;
    for (let i = first; i <= last; i++) if (bed[2 * i + 1] < bed[2 * lowest + 1]) lowest = i;
    crates[2 * k] = bed[2 * lowest];
    crates[2 * k + 1] = bed[2 * lowest + 1] + 1.2;
  }
  return { bed, crates, crushDepth: deepest + 6, current: Math.min(2, 0.4 * (level - 1)) };
}

/** Velocity of the water at a depth, m/s to the right. */
export function currentAt({ current }: Sea, depth: number): number {
  let sum = 0;
  for (const { depth: middle, half, sign } of BANDS) {
    const d = (depth - middle) / half;
    if (d > -1 && d < 1) sum += sign * (1 - d * d) * (1 - d * d);
  }
  return current * sum;
}
