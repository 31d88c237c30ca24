// Shells as data: what each kind throws how fast, how long it glows, and what becomes of it. Speeds and sizes are those
// of a power of 1. A star is a pellet of 1 g; its drag over its mass, ρ C_d A / 2m, is what tells willow from peony.

/** How the stars of a shell fly apart: over a ball, around a ring, or along a few fronds. */
export type ShellForm = 'ball' | 'ring' | 'palm';

export interface ShellKind {
  readonly name: string;
  readonly form: ShellForm;
  /** Stars of a shell; even, as they fly off in opposite pairs. */
  readonly stars: number;
  /** Number of their colour, whatever was ordered. */
  readonly color?: number;
  /** Speed of the fastest star, m/s, and of the slowest as a part of it. */
  readonly speed: number;
  readonly slowest: number;
  /** Shortest and longest life of a star, s. */
  readonly life: readonly [number, number];
  /** Drag coefficient over mass, 1/m. */
  readonly drag: number;
  /** Drawn radius over a life, m. */
  readonly size: readonly number[];
  /** Angle by which the magnetic field turns the velocity in a second, rad/s: the star is charged. */
  readonly turning?: number;
  /** Weight of the air it displaces over its own: above 1 it is a lantern full of hot air, and rises. */
  readonly buoyancy?: number;
  /** What each star becomes when it ends: how many stars of which other kind and colour. */
  readonly ends?: { readonly kind: number; readonly count: number; readonly color: number };
  /**
   * Each star bursts into as many of its own when it ends, until so many seconds after the shell burst. `color` is their
   * number; left out, each burst draws one.
   */
  readonly family?: { readonly seconds: number; readonly color?: number };
  /** Not thrown but lit where one points: two stars for every whole second that one holds, `stars` at most. */
  readonly isHeld?: boolean;
  /** Stars alive at once: about a dozen shells. 0 where families have their own. */
  readonly capacity: number;
  /** Whether it can be ordered: sparks of other stars cannot. */
  readonly isShell: boolean;
}

const STAR_SIZE = [0.22, 0.3, 0.24, 0.08];
const YELLOW = 2;
const GREEN = 3;
const SILVER = 6;
const common = { slowest: 0.9, size: STAR_SIZE, isShell: true, form: 'ball' } as const;

/** The stars of chains and swarms. Their pools are those of families, not of kinds. */
const chain: Omit<ShellKind, 'name'> = {
  ...common,
  speed: 13,
  slowest: 0.4,
  life: [2, 4],
  drag: 0.05,
  capacity: 0,
  stars: 10,
  size: [0.46, 0.44, 0.38, 0.26],
};

/** Every kind; those that are ordered come first, and a kind's place is its number in shows and logs. */
export const SHELLS: readonly ShellKind[] = [
  { ...common, name: 'peony', stars: 240, speed: 27, life: [1.3, 2], drag: 0.075, capacity: 3000 },
  {
    ...common,
    name: 'willow',
    stars: 160,
    speed: 16,
    slowest: 0.25,
    life: [2.8, 4.2],
    drag: 0.17,
    capacity: 2600,
    size: [0.2, 0.25, 0.2, 0.06],
  },
  {
    ...common,
    name: 'ring',
    form: 'ring',
    stars: 84,
    speed: 25,
    slowest: 0.97,
    life: [1.4, 1.8],
    drag: 0.06,
    capacity: 1300,
  },
  {
    ...common,
    name: 'crackle',
    stars: 110,
    speed: 23,
    slowest: 0.35,
    life: [0.9, 1.9],
    drag: 0.09,
    capacity: 1400,
    ends: { kind: 9, count: 6, color: SILVER },
  },
  {
    ...common,
    name: 'palm',
    form: 'palm',
    stars: 192,
    speed: 22,
    slowest: 0.5,
    life: [1.7, 2.7],
    drag: 0.055,
    size: [0.32, 0.38, 0.28, 0.08],
    capacity: 2200,
  },
  {
    ...common,
    name: 'charged',
    stars: 180,
    speed: 22,
    slowest: 0.3,
    life: [1.8, 2.8],
    drag: 0.03,
    turning: 4.5,
    capacity: 2200,
  },
  { ...chain, name: 'chain', family: { seconds: 6, color: GREEN } },
  {
    // Rises at √((b - 1) g / drag) = 2.2 m/s in the end, if nothing blows.
    ...common,
    name: 'lantern',
    stars: 44,
    speed: 19,
    slowest: 0.15,
    life: [5, 7.5],
    drag: 0.25,
    capacity: 600,
    size: [0.3, 0.46, 0.46, 0.12],
    buoyancy: 1.12,
  },
  { ...chain, name: 'swarm', color: YELLOW, isHeld: true, family: { seconds: 6 } },
  {
    ...common,
    name: 'spark',
    stars: 6,
    speed: 9,
    slowest: 0.5,
    life: [0.12, 0.34],
    drag: 0.3,
    capacity: 1800,
    size: [0.3, 0.24, 0.05],
    isShell: false,
  },
];

/** Names of the kinds that can be ordered, in the order of their numbers. */
export const SHELL_NAMES: readonly string[] = SHELLS.filter(({ isShell }) => isShell).map(({ name }) => name);

/** Stars of a burst of a kind that is held: two a second. @param power whole seconds, as a part of the most that count */
export function heldStars({ stars }: ShellKind, power: number): number {
  return 2 * Math.round(0.5 * stars * power);
}

/** Seconds of holding that count. */
export function mostSeconds({ stars }: ShellKind): number {
  return 0.5 * stars;
}
