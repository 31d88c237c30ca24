// Shells as data: speed, number, glow and fate of the stars of each kind. Speeds and sizes are those of power 1. A star
// is a pellet of 1 g; its drag over its mass, ρ C_d A / 2m, distinguishes a willow from a peony.

/** Distribution of the stars' velocities: over a ball, around a ring, or along a few fronds. */
export type ShellForm = 'ball' | 'ring' | 'palm';

/** A kind of shell: its stars, at full power. */
export interface ShellKind {
  readonly name: string;
  readonly form: ShellForm;
  /** Number of stars; even, because stars form opposite pairs. */
  readonly stars: number;
  /** Fixed colour index that overrides the chosen colour. */
  readonly color?: number;
  /** Speed of the fastest star, m/s, and the fraction of it that the slowest star has. */
  readonly speed: number;
  readonly minSpeedShare: number;
  /** Shortest and longest lifetime of a star, s. */
  readonly life: readonly [number, number];
  /** Drag coefficient over mass, 1/m. */
  readonly drag: number;
  /** Drawn radius over the lifetime, m. */
  readonly size: readonly number[];
  /** Angular velocity of gyration of a charged star in the magnetic field, rad/s. */
  readonly gyrationRate?: number;
  /** Weight of the displaced air over its own; above 1 the star is a lantern and rises. */
  readonly buoyancy?: number;
  /** Stars into which each star bursts when it expires: their kind, number and colour. */
  readonly ends?: { readonly kind: number; readonly count: number; readonly color: number };
  /**
   * Each expiring star bursts into `stars` stars of its own kind until this many seconds after the first burst. `color`
   * is their colour index; if omitted, it is random per burst.
   */
  readonly family?: { readonly seconds: number; readonly color?: number };
  /** Ignited at the pointer instead of launched: two stars per whole second of holding, at most `stars`. */
  readonly isHeld?: boolean;
  /** Capacity of the pool: about a dozen shells. 0 for kinds whose families have pools. */
  readonly capacity: number;
  /** Whether players can launch it; sparks of other stars cannot be launched. */
  readonly isShell: boolean;
}

const STAR_SIZE = [0.22, 0.3, 0.24, 0.08];
const YELLOW = 2;
const GREEN = 3;
const SILVER = 6;
const common = { minSpeedShare: 0.9, size: STAR_SIZE, isShell: true, form: 'ball' } as const;

/** The stars of chains and swarms. Their pools belong to families, not to kinds. */
const chain: Omit<ShellKind, 'name'> = {
  ...common,
  speed: 13,
  minSpeedShare: 0.4,
  life: [2, 4],
  drag: 0.05,
  capacity: 0,
  stars: 10,
  size: [0.46, 0.44, 0.38, 0.26],
};

/** All kinds; those that can be launched come first. The index of a kind is stored in shows and logs. */
export const SHELLS: readonly ShellKind[] = [
  { ...common, name: 'peony', stars: 240, speed: 27, life: [1.3, 2], drag: 0.075, capacity: 3000 },
  {
    ...common,
    name: 'willow',
    stars: 160,
    speed: 16,
    minSpeedShare: 0.25,
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
    minSpeedShare: 0.97,
    life: [1.4, 1.8],
    drag: 0.06,
    capacity: 1300,
  },
  {
    ...common,
    name: 'crackle',
    stars: 110,
    speed: 23,
    minSpeedShare: 0.35,
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
    minSpeedShare: 0.5,
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
    minSpeedShare: 0.3,
    life: [1.8, 2.8],
    drag: 0.03,
    gyrationRate: 4.5,
    capacity: 2200,
  },
  { ...chain, name: 'chain', family: { seconds: 6, color: GREEN } },
  {
    // Terminal velocity √((b - 1) g / drag) = 2.2 m/s in still air.
    ...common,
    name: 'lantern',
    stars: 44,
    speed: 19,
    minSpeedShare: 0.15,
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
    minSpeedShare: 0.5,
    life: [0.12, 0.34],
    drag: 0.3,
    capacity: 1800,
    size: [0.3, 0.24, 0.05],
    isShell: false,
  },
];

/** Names of the kinds that can be launched, in the order of their indices. */
export const SHELL_NAMES: readonly string[] = SHELLS.filter(({ isShell }) => isShell).map(({ name }) => name);

/** Number of stars of a held burst: two per second. @param power whole seconds as a fraction of the maximum */
export function heldStars({ stars }: ShellKind, power: number): number {
  return 2 * Math.round(0.5 * stars * power);
}

/** Longest effective hold, s. */
export function maxHoldSeconds({ stars }: ShellKind): number {
  return 0.5 * stars;
}
