// Stars that burst into more stars for some time. Every initial burst starts a family with its own pool and clock, so
// that families do not affect each other.
import { aliveCount, type Emitter, endings, keepState, type PhysicsWorld, type Random } from '@principia/physics';
import { STAR_COLORS } from './colors.ts';
import { type Point3, readPosition } from './place.ts';
import { SHELLS } from './shells.ts';

/** Capacity of a family; the largest of 300 families with ten stars per burst had 784. */
const MAX_STARS = 800;
const FAMILIES = 8;
/** Largest number of expired stars handled per step; further stars just go out. */
export const MAX_FOLLOWED = 60;

/** Bodies of all families. */
export const FAMILY_BODIES = FAMILIES * MAX_STARS;

/** Emits stars of a kind at a point from the pool of a family. */
export type EmitStars = (emitter: Emitter, kind: number, count: number, ramp: number, place: Point3) => void;

export class Families {
  readonly emitters: readonly Emitter[];
  readonly #world: PhysicsWorld;
  readonly #random: Random;
  /** Kind of the stars, stars per burst, and the world times of the family's start and of its last burst, s. */
  readonly #clocks = Array.from({ length: FAMILIES }, () => ({ kind: 0, stars: 0, from: -1, until: -1 }));

  readonly #place = { x: 0, y: 0, z: 0 };

  /** @param createPool creates a pool of the given capacity */
  constructor(world: PhysicsWorld, random: Random, createPool: (capacity: number) => Emitter) {
    this.#world = world;
    this.#random = random;
    this.emitters = this.#clocks.map(() => createPool(MAX_STARS));
    keepState(world, this.#clocks);
  }

  /** Starts a family. @returns its pool; that of the oldest family if none is free */
  start(kind: number, stars: number): Emitter {
    const { time } = this.#world;
    let place = 0;
    for (let i = 0; i < FAMILIES; i++) {
      if (this.#isFree(i)) {
        place = i;
        break;
      }
      if (this.#clocks[i].from < this.#clocks[place].from) place = i;
    }
    const clock = this.#clocks[place];
    clock.kind = kind;
    clock.stars = stars;
    clock.from = time;
    clock.until = time + (SHELLS[kind].family?.seconds ?? 0);
    return this.emitters[place];
  }

  #isFree(i: number): boolean {
    const emitter = this.emitters[i];
    return this.#clocks[i].from < this.#world.time && aliveCount(emitter) === 0 && endings(emitter).count === 0;
  }

  /** Lets the stars that expired in the last step burst while their family's time lasts. */
  follow(emitStars: EmitStars): void {
    for (let i = 0; i < FAMILIES; i++) {
      const emitter = this.emitters[i];
      const { kind, stars, until } = this.#clocks[i];
      const { count, states } = endings(emitter);
      if (count === 0 || this.#world.time >= until) continue;
      const given = SHELLS[kind].family?.color;
      for (let k = 0; k < Math.min(count, MAX_FOLLOWED); k++) {
        const ramp = given ?? this.#random.integer(0, STAR_COLORS.length - 1);
        emitStars(emitter, kind, stars, ramp, readPosition(states, k, this.#place));
      }
    }
  }
}
