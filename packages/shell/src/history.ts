// The last moments of a game, for going back: snapshots of its world.
import { restore, type Snapshot, snapshot } from '@principia/physics';
import type { Simulation } from './game.ts';

/** Simulated seconds that can be gone back, where memory allows more moments. */
const SECONDS = 20;
/** Memory for all moments together, bytes. */
const BUDGET = 96e6;
/** Least simulated time between two moments, s. */
const SHORTEST = 1 / 20;
/** A moment may take this share of the time between two. */
const SHARE = 0.04;

/** A ring of moments: new ones take the place of the oldest, and its memory. */
export class History {
  readonly #sim: Simulation;
  readonly #clock: () => number;
  /** Oldest first. */
  readonly #moments: Snapshot[] = [];
  /** Moments that were given up, for the next ones. */
  readonly #spare: Snapshot[] = [];
  #interval = SHORTEST;
  /** Bytes of the largest moment: with those of the last one, how many there may be would change to and fro. */
  #largest = 0;

  /** @param clock milliseconds; tells what a moment costs */
  constructor(sim: Simulation, clock: () => number) {
    this.#sim = sim;
    this.#clock = clock;
    this.note();
  }

  /** Simulated seconds from the first moment to now. */
  get length(): number {
    return this.#sim.world.time - this.#moments[0].time;
  }

  /** Notes the present moment, if the last one is long enough ago. */
  note(): void {
    const { world, dt } = this.#sim;
    const moments = this.#moments;
    const last = moments.length > 0 ? moments[moments.length - 1] : undefined;
    // A sum of steps may fall short by rounding.
    if (last !== undefined && world.time < last.time + this.#interval - dt / 2) return;
    const start = this.#clock();
    const most = Math.max(2, Math.floor(SECONDS / this.#interval));
    while (moments.length >= most) {
      this.#spare.push(moments[0]);
      // In place: a list that is shifted is made anew now and then.
      moments.copyWithin(0, 1);
      moments.pop();
    }
    const taken = snapshot(world, this.#spare.pop());
    moments.push(taken);
    const cost = (this.#clock() - start) / 1000;
    this.#largest = Math.max(this.#largest, taken.bytes);
    this.#interval = Math.max(SHORTEST, (SECONDS * this.#largest) / BUDGET, cost / SHARE);
    // What a moment costs varies, and with it how many there are: some of the others wait, as far as memory allows.
    while (this.#spare.length > 0 && (moments.length + this.#spare.length) * this.#largest > BUDGET) this.#spare.pop();
  }

  /**
   * Goes back to the last moment not after `time`, s, or to the first there is; moments after it are forgotten.
   * @returns whether the world changed
   */
  backTo(time: number): boolean {
    const moments = this.#moments;
    const { world, dt } = this.#sim;
    while (moments.length > 1 && moments[moments.length - 1].time > time + dt / 2) {
      this.#spare.push(moments.pop() as Snapshot);
    }
    const last = moments[moments.length - 1];
    if (world.tick <= last.tick) return false;
    restore(world, last);
    return true;
  }
}
