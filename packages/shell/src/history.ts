// The last moments of a game, for going back: snapshots of its world and what the game keeps beside it.
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

interface Moment {
  readonly taken: Snapshot;
  readonly putBack: () => void;
}

/** A ring of moments: new ones take the place of the oldest. */
export class History {
  readonly #sim: Simulation;
  readonly #remember: () => () => void;
  readonly #clock: () => number;
  #moments: Moment[] = [];
  #interval = SHORTEST;
  /** A moment no longer needed, whose memory the next one takes. */
  #spare: Snapshot | undefined;

  /**
   * @param remember notes what is not in the world, and returns what puts it back
   * @param clock milliseconds; tells what a moment costs
   */
  constructor(sim: Simulation, remember: () => () => void, clock: () => number) {
    this.#sim = sim;
    this.#remember = remember;
    this.#clock = clock;
    this.note();
  }

  /** Simulated seconds from the first moment to now. */
  get length(): number {
    return this.#sim.world.time - this.#moments[0].taken.time;
  }

  /** Notes the present moment, if the last one is long enough ago. */
  note(): void {
    const { world, dt } = this.#sim;
    const moments = this.#moments;
    const last = moments.at(-1);
    // A sum of steps may fall short by rounding.
    if (last !== undefined && world.time < last.taken.time + this.#interval - dt / 2) return;
    const start = this.#clock();
    const most = Math.max(2, Math.floor(SECONDS / this.#interval));
    while (moments.length >= most) this.#spare = (moments.shift() as Moment).taken;
    const taken = snapshot(world, this.#spare);
    this.#spare = undefined;
    moments.push({ taken, putBack: this.#remember() });
    const cost = (this.#clock() - start) / 1000;
    this.#interval = Math.max(SHORTEST, (SECONDS * taken.bytes) / BUDGET, cost / SHARE);
  }

  /**
   * Goes back to the last moment not after `time`, s, or to the first there is; moments after it are forgotten.
   * @returns whether the world changed
   */
  backTo(time: number): boolean {
    const moments = this.#moments;
    const { world, dt } = this.#sim;
    while (moments.length > 1 && (moments.at(-1) as Moment).taken.time > time + dt / 2) {
      this.#spare = (moments.pop() as Moment).taken;
    }
    const { taken, putBack } = moments.at(-1) as Moment;
    if (world.tick <= taken.tick) return false;
    restore(world, taken);
    putBack();
    return true;
  }
}
