/** The ground: a level airfield in a valley, and hills around it. Heights in m; the runway lies along x about the origin. */

/** The runway, m. Its western end, at -x, is where a flight begins; aeroplanes land towards the east. */
export const RUNWAY = { length: 1200, width: 36 } as const;

/** Half the side of the map, m. */
export const MAP_RADIUS = 9000;

/** The ground is level within this distance of the runway, m, and as high as hills get beyond the second. */
const LEVEL = 350;
const FAR = 3200;
const HILLS = 420;

/** A number from 0 to 1 for a corner of a grid, always the same. */
function cornerValue(i: number, j: number): number {
  let h = Math.imul(i, 0x27d4eb2d) ^ Math.imul(j, 0x165667b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 2 ** 32;
}

const smooth = (t: number) => t * t * (3 - 2 * t);
const unit = (t: number) => Math.min(1, Math.max(0, t));

/** Value noise: smooth between the corners of a grid of unit length. */
function noise(x: number, z: number): number {
  const [i, j] = [Math.floor(x), Math.floor(z)];
  const [u, v] = [smooth(x - i), smooth(z - j)];
  const near = cornerValue(i, j) * (1 - u) + cornerValue(i + 1, j) * u;
  const far = cornerValue(i, j + 1) * (1 - u) + cornerValue(i + 1, j + 1) * u;
  return near * (1 - v) + far * v;
}

/** Height of the ground, m. */
export function groundHeight(x: number, z: number): number {
  const beside = Math.max(0, Math.abs(x) - RUNWAY.length / 2);
  // The valley is open along the runway, for the approach.
  const distance = Math.sqrt(0.06 * beside * beside + z * z);
  if (distance <= LEVEL) return 0;
  const rise = smooth(unit((distance - LEVEL) / (FAR - LEVEL)));
  const shape =
    0.6 * noise(x / 1700 + 7, z / 1700) + 0.28 * noise(x / 620, z / 620 + 3) + 0.12 * noise(x / 210, z / 210);
  return HILLS * rise * shape * shape * 1.9;
}

/** Whether a point is on the tarmac. */
export function isOnRunway(x: number, z: number): boolean {
  return Math.abs(x) <= RUNWAY.length / 2 && Math.abs(z) <= RUNWAY.width / 2;
}
