// Stars that burst into stars for a while: every burst founds a family with a pool, a clock and a number of its own, so
// that another one beside it changes neither.
import { aliveCount, type Emitter, endings, keepState, type PhysicsWorld, type Random } from '@principia/physics';
import { STAR_COLORS } from './colors.ts';
import { type Place, readPlace } from './place.ts';
import { SHELLS } from './shells.ts';

/** Stars of a family at once: of 300 with ten stars a burst the largest had 784. */
const MOST_STARS = 800;
const FAMILIES = 8;
/** Ends of stars that a step follows; stars beyond that just go out. */
export const MOST_FOLLOWED = 60;

/** Bodies of all families. */
export const FAMILY_BODIES = FAMILIES * MOST_STARS;

/** Bears stars of a kind at a place, in the pool of a family. */
export type BearStars = (emitter: Emitter, kind: number, count: number, ramp: number, place: Place) => void;

export class Families {
  readonly emitters: readonly Emitter[];
  readonly #world: PhysicsWorld;
  readonly #random: Random;
  /** Kind of its stars; how many each bursts into; world times it was founded at and bursts until, s. */
  readonly #clocks = Array.from({ length: FAMILIES }, () => ({ kind: 0, stars: 0, from: -1, until: -1 }));

  readonly #place = { x: 0, y: 0, z: 0 };

  /** @param createPool makes a pool for so many stars */
  constructor(world: PhysicsWorld, random: Random, createPool: (capacity: number) => Emitter) {
    this.#world = world;
    this.#random = random;
    this.emitters = this.#clocks.map(() => createPool(MOST_STARS));
    keepState(world, this.#clocks);
  }

  /** @returns the pool that the first stars are to be born in; the oldest family's where none is free */
  found(kind: number, stars: number): Emitter {
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

  /** Lets the stars that ended in the last step burst, as long as their family's time lasts. */
  follow(bear: BearStars): void {
    for (let i = 0; i < FAMILIES; i++) {
      const emitter = this.emitters[i];
      const { kind, stars, until } = this.#clocks[i];
      const { count, states } = endings(emitter);
      if (count === 0 || this.#world.time >= until) continue;
      const given = SHELLS[kind].family?.color;
      for (let k = 0; k < Math.min(count, MOST_FOLLOWED); k++) {
        const ramp = given ?? this.#random.integer(0, STAR_COLORS.length - 1);
        bear(emitter, kind, stars, ramp, readPlace(states, k, this.#place));
      }
    }
  }
}
