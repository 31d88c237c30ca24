/** The course of rings, and where a mission begins. */
import type { Axes } from './body-frame.ts';
import { groundHeight, RUNWAY } from './terrain.ts';

export const MISSIONS = ['circuit', 'landing', 'free'] as const;
export type Mission = (typeof MISSIONS)[number];

/** Radius of a ring, m: three wing spans. */
export const RING_RADIUS = 32;

/** A ring: its centre, m, and the level direction in which it is flown through. */
export interface Ring {
  readonly at: Readonly<Axes>;
  readonly direction: Readonly<Axes>;
}

/** A left-hand circuit: x, height above the lowest ground, z. */
const PLACES = [
  [1500, 90, 0],
  [2350, 170, -600],
  [2000, 230, -1350],
  [600, 240, -1500],
  [-1100, 230, -1450],
  [-2350, 190, -950],
  [-2500, 150, -120],
] as const;

function createRings(): Ring[] {
  const centres = PLACES.map(([x, height, z]) => ({ x, y: Math.max(height, groundHeight(x, z) + 90), z }));
  return centres.map((at, i) => {
    const before = i === 0 ? { x: 0, z: 0 } : centres[i - 1];
    const after = centres[i + 1] ?? { x: -RUNWAY.length / 2, z: 0 };
    const [x, z] = [after.x - before.x, after.z - before.z];
    const length = Math.sqrt(x * x + z * z);
    return { at, direction: { x: x / length, y: 0, z: z / length } };
  });
}

export const RINGS: readonly Ring[] = createRings();

/** State of the aeroplane at the start of a mission: SI units, the nose to the east. */
export interface Start {
  readonly at: Readonly<Axes>;
  readonly speed: number;
  readonly throttle: number;
}

/** Height of the centre of mass with the wheels on the ground, m. */
export const RESTING_HEIGHT = 1.2;

export function startOf(mission: Mission): Start {
  const threshold = -RUNWAY.length / 2;
  // Two kilometres and a half before the runway, on a path of four degrees.
  if (mission === 'landing') return { at: { x: threshold - 2500, y: 190, z: 60 }, speed: 38, throttle: 0.42 };
  return { at: { x: threshold + 40, y: RESTING_HEIGHT, z: 0 }, speed: 0, throttle: 0 };
}
