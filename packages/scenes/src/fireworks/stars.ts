// The pools of stars, one a kind of shell, and how a shell's stars are born.
import {
  aliveCount,
  type BurstPattern,
  burst,
  createEmitter,
  createPattern,
  type Emitter,
  endings,
  keepState,
  type PhysicsWorld,
  type Random,
  setEmitter,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { colorRamp, STAR_COLORS, STAR_RGB } from './colors';
import { formVelocities } from './forms';
import { SHELLS, type ShellKind } from './shells';

/** Mass of a star, kg. */
export const STAR_MASS = 0.001;
/** Different shells of a kind. */
const VARIANTS = 5;
/** From this power on a smaller ball glows inside the large one, in the next colour. */
const PISTIL_POWER = 0.6;

/** Numbers that bursts are asked with. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

interface BurstOrder {
  position: Place;
  velocity: Place;
  ramp: number;
  pattern: BurstPattern | undefined;
  scale: number;
}

const STILL: Place = { x: 0, y: 0, z: 0 };

/** Factor of a shell's speeds by its power. */
export function strengthOf(power: number): number {
  return 0.72 + 0.56 * power;
}

export class StarPools {
  readonly emitters: readonly Emitter[];
  readonly #patterns: readonly (readonly BurstPattern[])[];
  readonly #until = SHELLS.map(() => Number.NEGATIVE_INFINITY);
  readonly #random: Random;
  readonly #world: PhysicsWorld;
  readonly #place = { x: 0, y: 0, z: 0 };
  /** What a burst is asked with, written anew for each. */
  readonly #order: BurstOrder = { position: STILL, velocity: STILL, ramp: 0, pattern: undefined, scale: 1 };

  constructor(world: PhysicsWorld, random: Random) {
    this.#world = world;
    this.#random = random;
    keepState(world, this.#until);
    this.emitters = SHELLS.map((kind) => createStars(world, kind));
    this.#patterns = SHELLS.map((kind) =>
      Array.from({ length: VARIANTS }, () => createPattern(world, formVelocities(kind, world.dimensions, random))),
    );
  }

  /** Stars of all kinds alive now. */
  get alive(): number {
    let sum = 0;
    for (let i = 0; i < this.emitters.length; i++) sum += aliveCount(this.emitters[i]);
    return sum;
  }

  /** @param colors eight, as 0xRRGGBB */
  setColors(colors: readonly number[]): void {
    for (const emitter of this.emitters) setEmitter(emitter, { color: rampsOf(colors) });
  }

  /** Bears the stars of a shell at the next emission. */
  break(kind: number, color: number, power: number, position: Place, velocity: Place): void {
    const { speed, ends } = SHELLS[kind];
    const scale = speed * strengthOf(power);
    this.#burst(kind, position, velocity, color, scale);
    if (power >= PISTIL_POWER) this.#burst(kind, position, velocity, (color + 2) % STAR_COLORS.length, 0.5 * scale);
    if (ends?.until !== undefined) this.#until[kind] = this.#world.time + ends.until;
  }

  /** Lets the stars that ended in the last step become what their kind says. @param crackled told where */
  follow(crackled: (place: Place) => void): void {
    for (let kind = 0; kind < SHELLS.length; kind++) {
      const { ends } = SHELLS[kind];
      if (ends === undefined) continue;
      const { count, states } = endings(this.emitters[kind]);
      if (ends.until !== undefined && this.#world.time >= this.#until[kind]) continue;
      // No more than fit into a step; the others just go out.
      for (let i = 0; i < Math.min(count, MOST_FOLLOWED); i++) {
        const position = this.#place;
        position.x = states[6 * i];
        position.y = states[6 * i + 1];
        position.z = states[6 * i + 2];
        // The book's sparks turn green; crackling ones are silver.
        this.#burst(
          ends.kind,
          position,
          STILL,
          ends.kind === kind ? GREEN : SILVER,
          SHELLS[ends.kind].speed,
          ends.count,
        );
        if (ends.kind !== kind) crackled(position);
      }
    }
  }

  #burst(
    kind: number,
    position: Place,
    velocity: Place,
    ramp: number,
    scale: number,
    count = SHELLS[kind].stars,
  ): void {
    const patterns = this.#patterns[kind];
    const order = this.#order;
    order.position = position;
    order.velocity = velocity;
    order.ramp = ramp;
    order.pattern = patterns[this.#random.integer(0, patterns.length - 1)];
    order.scale = scale;
    burst(this.emitters[kind], count, order);
  }
}

const MOST_FOLLOWED = 60;
const GREEN = 3;
const SILVER = 6;

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
  const { capacity, life, drag, size, turning, buoyancy, ends } = kind;
  const emitter = createEmitter(world, {
    ...{ capacity, lifetime: life, size, mass: STAR_MASS, quadraticDrag: drag * STAR_MASS, whenFull: 'oldest' },
    ...{
      speed: 0,
      sizeFactor: [0.75, 1.2],
      shape: GLOW,
      color: rampsOf(STAR_RGB),
      reportEndings: ends !== undefined,
    },
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
