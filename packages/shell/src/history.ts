// A ring of world snapshots for rewinding a game.
import { restore, type Snapshot, snapshot } from '@principia/physics';
import type { Simulation } from './game.ts';

/** Longest rewind in simulated seconds, where memory allows. */
const MAX_SECONDS = 20;
/** Limit of the memory for all snapshots, bytes. */
const MAX_BYTES = 96e6;
/** Shortest simulated time between two snapshots, s. */
const MIN_INTERVAL = 1 / 20;
/** Largest share of the running time that taking snapshots may cost. */
const MAX_COST_SHARE = 0.04;

/** A ring of snapshots: a new snapshot reuses the memory of the oldest. */
export class History {
  readonly #sim: Simulation;
  readonly #clock: () => number;
  /** Oldest first. */
  readonly #snapshots: Snapshot[] = [];
  /** Discarded snapshots whose memory is reused. */
  readonly #spare: Snapshot[] = [];
  #interval = MIN_INTERVAL;
  /** Bytes of the largest snapshot. The size of the last one would make the number of snapshots oscillate. */
  #largest = 0;

  /** @param clock milliseconds; measures the cost of a snapshot */
  constructor(sim: Simulation, clock: () => number) {
    this.#sim = sim;
    this.#clock = clock;
    this.record();
  }

  /** Simulated seconds from the oldest snapshot to the present. */
  get length(): number {
    return this.#sim.world.time - this.#snapshots[0].time;
  }

  /** Takes a snapshot if the last one is old enough. */
  record(): void {
    const { world, dt } = this.#sim;
    const snapshots = this.#snapshots;
    const last = snapshots.length > 0 ? snapshots[snapshots.length - 1] : undefined;
    // Rounding may leave the sum of the steps slightly short.
    if (last !== undefined && world.time < last.time + this.#interval - dt / 2) return;
    const start = this.#clock();
    const maxCount = Math.max(2, Math.floor(MAX_SECONDS / this.#interval));
    while (snapshots.length >= maxCount) {
      this.#spare.push(snapshots[0]);
      // `copyWithin` works in place; `shift` would reallocate the list now and then.
      snapshots.copyWithin(0, 1);
      snapshots.pop();
    }
    const taken = snapshot(world, this.#spare.pop());
    snapshots.push(taken);
    const cost = (this.#clock() - start) / 1000;
    this.#largest = Math.max(this.#largest, taken.bytes);
    this.#interval = Math.max(MIN_INTERVAL, (MAX_SECONDS * this.#largest) / MAX_BYTES, cost / MAX_COST_SHARE);
    // The cost of a snapshot varies, and with it their number; spare ones are kept as far as memory allows.
    while (this.#spare.length > 0 && (snapshots.length + this.#spare.length) * this.#largest > MAX_BYTES)
      this.#spare.pop();
  }

  /**
   * Restores the last snapshot not after `time`, s, or the oldest one, and discards later snapshots.
   * @returns whether the world changed
   */
  restoreTo(time: number): boolean {
    const snapshots = this.#snapshots;
    const { world, dt } = this.#sim;
    while (snapshots.length > 1 && snapshots[snapshots.length - 1].time > time + dt / 2) {
      this.#spare.push(snapshots.pop() as Snapshot);
    }
    const last = snapshots[snapshots.length - 1];
    if (world.tick <= last.tick) return false;
    restore(world, last);
    return true;
  }
}
