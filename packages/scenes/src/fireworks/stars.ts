// The pools of stars, one for each kind of shell, and the emission of a shell's stars.
import {
  aliveCount,
  type BurstPattern,
  burst,
  createEmitter,
  createPattern,
  type Emitter,
  emitterCounts,
  endings,
  keepState,
  type PhysicsWorld,
  type Random,
  setEmitter,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { colorRamp, STAR_COLORS, STAR_RGB } from './colors.ts';
import { type EmitStars, Families, MAX_FOLLOWED } from './families.ts';
import { formVelocities } from './forms.ts';
import { MAX_TEXT_STARS, TEXT_STRIDE, textVelocities } from './letters.ts';
import { ORIGIN, type Point3, readPosition } from './place.ts';
import { heldStars, SHELLS, type ShellKind } from './shells.ts';

/** Mass of a star, kg. */
export const STAR_MASS = 0.001;
/** Random variants of each kind. */
const VARIANTS = 5;
/** From this power on, a shell has a smaller inner ball in another colour. */
const PISTIL_POWER = 0.6;

interface BurstOrder {
  position: Point3;
  velocity: Point3;
  ramp: number;
  pattern: BurstPattern | undefined;
  scale: number;
}

/** Speed factor of a shell by its power. */
export function strengthOf(power: number): number {
  return 0.72 + 0.56 * power;
}

export class StarPools {
  /** By index of the kind; kinds with families have none. */
  readonly #pools: readonly (Emitter | undefined)[];
  readonly #emitters: readonly Emitter[];
  readonly #families: Families;
  readonly #patterns: readonly (readonly BurstPattern[])[];
  readonly #random: Random;
  readonly #world: PhysicsWorld;
  /** Tick at which a text burst last. A typed array, because snapshots copy it without garbage. */
  readonly #writtenAt = new Float64Array([-1]);
  readonly #place = { x: 0, y: 0, z: 0 };
  /** The parameters of a burst, reused. */
  readonly #order: BurstOrder = { position: ORIGIN, velocity: ORIGIN, ramp: 0, pattern: undefined, scale: 1 };

  /** Stars of stars inherit no velocity. */
  readonly #emitStars: EmitStars = (emitter, kind, count, ramp, place) => {
    this.#burst(emitter, kind, count, ramp, place, ORIGIN, SHELLS[kind].speed);
  };

  constructor(world: PhysicsWorld, random: Random) {
    this.#random = random;
    this.#world = world;
    keepState(world, this.#writtenAt);
    this.#pools = SHELLS.map((kind) => (kind.family === undefined ? createStars(world, kind) : undefined));
    this.#families = new Families(world, random, (capacity) => createStars(world, { ...FAMILY_KIND, capacity }));
    this.#emitters = [...this.#pools.filter((pool) => pool !== undefined), ...this.#families.emitters];
    this.#patterns = SHELLS.map((kind) =>
      Array.from({ length: VARIANTS }, () => createPattern(world, formVelocities(kind, world.dimensions, random))),
    );
  }

  /** Stars of all kinds alive now. */
  get alive(): number {
    let sum = 0;
    for (let i = 0; i < this.#emitters.length; i++) sum += aliveCount(this.#emitters[i]);
    return sum;
  }

  /** Stars born so far. */
  get born(): number {
    return this.#emitters.reduce((sum, emitter) => sum + emitterCounts(emitter).born, 0);
  }

  /** @param colors eight, as 0xRRGGBB */
  setColors(colors: readonly number[]): void {
    for (const emitter of this.#emitters) setEmitter(emitter, { color: rampsOf(colors) });
  }

  /** Emits the stars of a shell in the next emission. */
  break(kind: number, color: number, power: number, position: Point3, velocity: Point3): void {
    const shell = SHELLS[kind];
    const scale = shell.speed * strengthOf(power);
    const ramp = shell.color ?? color;
    const count = shell.isHeld ? heldStars(shell, power) : shell.stars;
    this.#burst(this.#poolFor(kind, count), kind, count, ramp, position, velocity, scale);
    if (power < PISTIL_POWER || shell.isHeld) return;
    const inner = (ramp + 2) % STAR_COLORS.length;
    this.#burst(this.#poolFor(kind, count), kind, count, inner, position, velocity, 0.5 * scale);
  }

  /**
   * Emits the stars of a text. Where two texts burst in one step, there are bursts for one; the other is a plain shell.
   * @param points as in `ShellOrder`; stars beyond `MAX_TEXT_STARS` are left out
   */
  write(points: readonly number[], color: number, power: number, position: Point3, velocity: Point3): void {
    const pool = this.#pools[TEXT_KIND] as Emitter;
    if (this.#writtenAt[0] === this.#world.tick) {
      this.break(TEXT_KIND, color, power, position, velocity);
      return;
    }
    this.#writtenAt[0] = this.#world.tick;
    const velocities = textVelocities(points.slice(0, TEXT_STRIDE * MAX_TEXT_STARS), SHELLS[TEXT_KIND].drag);
    const order = { position, velocity: { x: 0, y: 0, z: velocity.z }, ramp: 0 };
    for (let i = 0; 2 * i < velocities.length; i++) {
      order.velocity.x = velocity.x + velocities[2 * i];
      order.velocity.y = velocity.y + velocities[2 * i + 1];
      const own = points[TEXT_STRIDE * i + 2];
      order.ramp = own < 0 ? color : own;
      burst(pool, 1, order);
    }
  }

  /** Handles the stars that expired in the last step. @param onCrackle receives the positions of crackling stars */
  follow(onCrackle: (place: Point3) => void): void {
    this.#families.follow(this.#emitStars);
    for (let kind = 0; kind < SHELLS.length; kind++) {
      const { ends } = SHELLS[kind];
      const pool = this.#pools[kind];
      if (ends === undefined || pool === undefined) continue;
      const { count, states } = endings(pool);
      for (let i = 0; i < Math.min(count, MAX_FOLLOWED); i++) {
        const place = readPosition(states, i, this.#place);
        this.#emitStars(this.#poolFor(ends.kind, ends.count), ends.kind, ends.count, ends.color, place);
        onCrackle(place);
      }
    }
  }

  #poolFor(kind: number, count: number): Emitter {
    return this.#pools[kind] ?? this.#families.start(kind, count);
  }

  #burst(
    emitter: Emitter,
    kind: number,
    count: number,
    ramp: number,
    position: Point3,
    velocity: Point3,
    scale: number,
  ): void {
    const patterns = this.#patterns[kind];
    const order = this.#order;
    order.position = position;
    order.velocity = velocity;
    order.ramp = ramp;
    order.pattern = patterns[this.#random.integer(0, patterns.length - 1)];
    order.scale = scale;
    burst(emitter, count, order);
  }
}

/** The kind whose stars form texts: lanterns come to rest and hover. */
const TEXT_KIND = SHELLS.findIndex(({ name }) => name === 'lantern');

/** All kinds with families have the same stars. */
const FAMILY_KIND = SHELLS.find(({ family }) => family !== undefined) as ShellKind;

export function rampsOf(colors: readonly number[]): number[][] {
  return colors.map((color) => colorRamp(color));
}

/** Density of air, kg/m³. */
export const AIR_DENSITY = 1.2;

/**
 * Creates the pool of a kind. In the field of 1 T, the charge gives the requested rate of gyration, and the hull volume
 * gives the buoyancy. The added mass of air is neglected, which shortens only the time to reach terminal velocity.
 */
function createStars(world: PhysicsWorld, kind: ShellKind): Emitter {
  const { capacity, life, drag, size, gyrationRate, buoyancy, ends, family } = kind;
  const emitter = createEmitter(world, {
    capacity,
    lifetime: life,
    size,
    mass: STAR_MASS,
    quadraticDrag: drag * STAR_MASS,
    whenFull: 'oldest',
    speed: 0,
    sizeFactor: [0.75, 1.2],
    shape: GLOW,
    color: rampsOf(STAR_RGB),
    reportEndings: ends !== undefined || family !== undefined,
  });
  if (gyrationRate !== undefined) {
    const { Charge } = world.components;
    for (const id of emitter.ids) addComponent(world, id, set(Charge, { value: gyrationRate * STAR_MASS }));
  }
  if (buoyancy !== undefined) {
    const { Hull } = world.components;
    const volume = (buoyancy * STAR_MASS) / AIR_DENSITY;
    for (const id of emitter.ids) addComponent(world, id, set(Hull, { volume }));
  }
  return emitter;
}

/** The renderers' soft spot of light: SHAPES.glow. */
export const GLOW = 4;
