// The pools of stars, one a kind of shell, and how a shell's stars are born.
import {
  aliveCount,
  type BurstPattern,
  burst,
  createEmitter,
  createPattern,
  type Emitter,
  emitterCounts,
  endings,
  type PhysicsWorld,
  type Random,
  setEmitter,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { colorRamp, STAR_COLORS, STAR_RGB } from './colors.ts';
import { type BearStars, Families, MOST_FOLLOWED } from './families.ts';
import { formVelocities } from './forms.ts';
import { type Place, readPlace, STILL } from './place.ts';
import { heldStars, SHELLS, type ShellKind } from './shells.ts';

/** Mass of a star, kg. */
export const STAR_MASS = 0.001;
/** Different shells of a kind. */
const VARIANTS = 5;
/** From this power on a smaller ball glows inside the large one, in the next colour. */
const PISTIL_POWER = 0.6;

interface BurstOrder {
  position: Place;
  velocity: Place;
  ramp: number;
  pattern: BurstPattern | undefined;
  scale: number;
}

/** Factor of a shell's speeds by its power. */
export function strengthOf(power: number): number {
  return 0.72 + 0.56 * power;
}

export class StarPools {
  /** By the number of the kind; kinds of families have none. */
  readonly #pools: readonly (Emitter | undefined)[];
  readonly #emitters: readonly Emitter[];
  readonly #families: Families;
  readonly #patterns: readonly (readonly BurstPattern[])[];
  readonly #random: Random;
  readonly #place = { x: 0, y: 0, z: 0 };
  /** What a burst is asked with, written anew for each. */
  readonly #order: BurstOrder = { position: STILL, velocity: STILL, ramp: 0, pattern: undefined, scale: 1 };

  /** Stars of stars inherit no velocity. */
  readonly #bear: BearStars = (emitter, kind, count, ramp, place) => {
    this.#burst(emitter, kind, count, ramp, place, STILL, SHELLS[kind].speed);
  };

  constructor(world: PhysicsWorld, random: Random) {
    this.#random = random;
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

  /** Bears the stars of a shell at the next emission. */
  break(kind: number, color: number, power: number, position: Place, velocity: Place): void {
    const shell = SHELLS[kind];
    const scale = shell.speed * strengthOf(power);
    const ramp = shell.color ?? color;
    const count = shell.isHeld ? heldStars(shell, power) : shell.stars;
    this.#burst(this.#poolFor(kind, count), kind, count, ramp, position, velocity, scale);
    if (power < PISTIL_POWER || shell.isHeld) return;
    const inner = (ramp + 2) % STAR_COLORS.length;
    this.#burst(this.#poolFor(kind, count), kind, count, inner, position, velocity, 0.5 * scale);
  }

  /** Lets the stars that ended in the last step become what their kind says. @param crackled told where */
  follow(crackled: (place: Place) => void): void {
    this.#families.follow(this.#bear);
    for (let kind = 0; kind < SHELLS.length; kind++) {
      const { ends } = SHELLS[kind];
      const pool = this.#pools[kind];
      if (ends === undefined || pool === undefined) continue;
      const { count, states } = endings(pool);
      for (let i = 0; i < Math.min(count, MOST_FOLLOWED); i++) {
        const place = readPlace(states, i, this.#place);
        this.#bear(this.#poolFor(ends.kind, ends.count), ends.kind, ends.count, ends.color, place);
        crackled(place);
      }
    }
  }

  #poolFor(kind: number, count: number): Emitter {
    return this.#pools[kind] ?? this.#families.found(kind, count);
  }

  #burst(
    emitter: Emitter,
    kind: number,
    count: number,
    ramp: number,
    position: Place,
    velocity: Place,
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

/** All kinds that families have are of the same stars. */
const FAMILY_KIND = SHELLS.find(({ family }) => family !== undefined) as ShellKind;

export function rampsOf(colors: readonly number[]): number[][] {
  return colors.map((color) => colorRamp(color));
}

/** Density of air, kg/m³. */
export const AIR_DENSITY = 1.2;

/**
 * Charges them too: the field's strength is 1 T, so the charge is what turns them as told. And gives them the volume
 * of air that lifts them; the inertia of the air they drag along is left out, which changes how soon they rise as fast.
 */
function createStars(world: PhysicsWorld, kind: ShellKind): Emitter {
  const { capacity, life, drag, size, turning, buoyancy, ends, family } = kind;
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
  if (turning !== undefined) {
    const { Charge } = world.components;
    for (const id of emitter.ids) addComponent(world, id, set(Charge, { value: turning * STAR_MASS }));
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
