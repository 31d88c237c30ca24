// A ring of world snapshots for rewinding a game, and for looking at any recorded moment.
import { restore, type Snapshot, snapshot, stateHash, step } from '@principia/physics';
import type { Simulation } from './game.ts';

/** Longest rewind in simulated seconds, where memory allows and the game asks for no other. */
const MAX_SECONDS = 20;
/** Limit of the memory for all snapshots, bytes. */
const MAX_BYTES = 96e6;
/** Most snapshots in the whole span, so that 20 s have one every twentieth of a second. */
const MAX_COUNT = 400;
/** Largest share of the running time that taking snapshots may cost. */
const MAX_COST_SHARE = 0.04;
/** Of so many snapshots the cheapest counts: one that was interrupted, or ran cold code, says nothing of the next. */
const COSTS = 3;

/**
 * A ring of snapshots: a new snapshot reuses the memory of the oldest. Restoring one keeps those after it, so that one
 * can go to and fro, until the world steps on from there.
 */
export class History {
  readonly #sim: Simulation;
  readonly #clock: () => number;
  /** Oldest first. */
  readonly #snapshots: Snapshot[] = [];
  /** Discarded snapshots whose memory is reused. */
  readonly #spare: Snapshot[] = [];
  /** Longest rewind, and shortest time between two snapshots, s. */
  readonly #span: number;
  readonly #minInterval: number;
  #interval: number;
  /** Index of the snapshot that the world stands at since it was restored; otherwise the last one. */
  #at = -1;
  /** Bytes of the largest snapshot. The size of the last one would make the number of snapshots oscillate. */
  #largest = 0;
  /** What the last snapshots cost, s, and how many were taken. */
  readonly #costs = new Float64Array(COSTS).fill(Number.POSITIVE_INFINITY);
  #taken = 0;
  /** Where the last step back led, and the hash that the world had there before anything was released. */
  readonly #steppedTo = { tick: -1, hash: '' };

  /**
   * @param clock milliseconds; measures the cost of a snapshot
   * @param span longest rewind in simulated seconds, where memory allows
   */
  constructor(sim: Simulation, clock: () => number, span = MAX_SECONDS) {
    this.#sim = sim;
    this.#clock = clock;
    this.#span = span;
    this.#minInterval = span / MAX_COUNT;
    this.#interval = this.#minInterval;
    this.#take();
  }

  /** Number of moments that can be restored. */
  get count(): number {
    return this.#snapshots.length;
  }

  /** Index of the moment that the world stands at or came from last. */
  get index(): number {
    return this.#at;
  }

  /** Time of a moment, s. */
  timeAt(index: number): number {
    return this.#snapshots[index].time;
  }

  /** Whether recorded moments lie after the present one: the world was moved back and has not stepped on. */
  get hasLater(): boolean {
    return this.#at < this.#snapshots.length - 1;
  }

  /** Simulated seconds from the oldest snapshot to the present. */
  get length(): number {
    return this.#sim.world.time - this.#snapshots[0].time;
  }

  /** Takes a snapshot if the last one is old enough. Call it after a step: what was recorded later is discarded. */
  record(): void {
    const { world, dt } = this.#sim;
    const snapshots = this.#snapshots;
    while (this.hasLater) this.#spare.push(snapshots.pop() as Snapshot);
    this.#steppedTo.tick = -1;
    // Rounding may leave the sum of the steps slightly short.
    if (world.time < snapshots[this.#at].time + this.#interval - dt / 2) return;
    this.#take();
  }

  /**
   * Restores the last moment not after `time`, s, or the first one. Later moments stay until the world steps on.
   * @param keepsPresent whether the present moment is kept as well when the world first leaves it
   * @returns whether the world changed
   */
  seek(time: number, keepsPresent = true): boolean {
    const { world } = this.#sim;
    if (keepsPresent && !this.hasLater && world.tick !== this.#snapshots[this.#at].tick) this.#take();
    return this.#restore(this.#indexOf(time));
  }

  /**
   * Restores the last moment not after `time`, s, or the first one, if that lies before the present.
   * @returns whether the world changed
   */
  restoreTo(time: number): boolean {
    const index = Math.min(this.#at, this.#indexOf(time));
    return this.#sim.world.tick > this.#snapshots[index].tick && this.#restore(index);
  }

  /**
   * Goes back by one step: restores the moment before it and takes the steps since then again. What a player did between
   * two moments is not recorded: if the steps now lead elsewhere than to the present, or throw, the world stays at that moment.
   * @returns whether the world changed
   */
  stepBack(): boolean {
    const { world } = this.#sim;
    const { tick } = world;
    const index = this.#snapshots.findLastIndex((moment) => moment.tick < tick);
    if (index < 0) return false;
    const { tick: from } = this.#snapshots[index];
    const hash = from === tick - 1 ? '' : this.#hashAt(tick);
    this.#restore(index);
    if (from < tick - 1) this.#repeatSteps(index, tick - 1, hash);
    return true;
  }

  /** Hash of the world at the present tick, as it came from its steps: what was dragged may have been released since. */
  #hashAt(tick: number): string {
    if (this.#steppedTo.tick === tick) return this.#steppedTo.hash;
    const moment = this.#snapshots.find((each) => each.tick === tick);
    if (moment !== undefined) restore(this.#sim.world, moment);
    return stateHash(this.#sim.world);
  }

  /** Steps from moment `index` to `tick`, and back to the moment unless the next step gives a world of hash `next`. */
  #repeatSteps(index: number, tick: number, next: string): void {
    const { world, dt } = this.#sim;
    let reached: Snapshot | undefined;
    let hash = '';
    let isSame = false;
    try {
      while (world.tick < tick) step(world, dt);
      reached = snapshot(world, this.#spare.pop());
      hash = stateHash(world);
      step(world, dt);
      isSame = stateHash(world) === next;
    } catch {
      // A step that throws is why the player goes back: the moment before it is restored.
    }
    restore(world, isSame && reached !== undefined ? reached : this.#snapshots[index]);
    if (reached !== undefined) this.#spare.push(reached);
    Object.assign(this.#steppedTo, { tick: isSame ? tick : -1, hash });
  }

  /** Index of the last snapshot not after a time, or of the first. */
  #indexOf(time: number): number {
    const snapshots = this.#snapshots;
    let index = snapshots.length - 1;
    while (index > 0 && snapshots[index].time > time + this.#sim.dt / 2) index--;
    return index;
  }

  #restore(index: number): boolean {
    const { world } = this.#sim;
    const wanted = this.#snapshots[index];
    this.#at = index;
    if (world.tick === wanted.tick) return false;
    restore(world, wanted);
    return true;
  }

  #take(): void {
    const snapshots = this.#snapshots;
    const start = this.#clock();
    const maxCount = Math.max(2, Math.floor(this.#span / this.#interval));
    while (snapshots.length >= maxCount) {
      this.#spare.push(snapshots[0]);
      // `copyWithin` works in place; `shift` would reallocate the list now and then.
      snapshots.copyWithin(0, 1);
      snapshots.pop();
    }
    const taken = snapshot(this.#sim.world, this.#spare.pop());
    snapshots.push(taken);
    this.#at = snapshots.length - 1;
    const cost = this.#noteCost((this.#clock() - start) / 1000);
    this.#largest = Math.max(this.#largest, taken.bytes);
    this.#interval = Math.max(this.#minInterval, (this.#span * this.#largest) / MAX_BYTES, cost / MAX_COST_SHARE);
    // The cost of a snapshot varies, and with it their number; spare ones are kept as far as memory allows.
    while (this.#spare.length > 0 && (snapshots.length + this.#spare.length) * this.#largest > MAX_BYTES)
      this.#spare.pop();
  }

  /** @returns what a snapshot costs, s: the least of the last ones; nothing after the first, which runs cold */
  #noteCost(cost: number): number {
    const index = this.#taken++;
    if (index === 0) return 0;
    this.#costs[index % COSTS] = cost;
    let least = cost;
    for (let i = 0; i < COSTS; i++) least = Math.min(least, this.#costs[i]);
    return least;
  }
}
