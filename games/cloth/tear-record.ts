/**
 * Records the last seconds of a cloth, thirty positions a second for each node and the step at which each thread ended,
 * so that a tear can be watched again slowly.
 */
import type { Cloth, PhysicsWorld } from '@principia/physics';
import { entityExists, query } from 'bitecs';

/** Steps between two frames, and how many frames are kept: 8 s. */
const FRAME_STEPS = 2;
export const MAX_FRAMES = 240;
/** What belongs to a tear before its first thread ends and after its last one has ended, steps. */
const [LEAD_IN, LEAD_OUT] = [24, 45];
/** Threads of the shortest tear that is worth a film. */
const MIN_ENDED = 6;

/** A part of the record, by the ticks of its ends. */
export interface Tear {
  readonly from: number;
  readonly to: number;
}

export class TearRecord {
  /** The two nodes of each thread, from 0, and the tick at which it ended; Infinity while it holds. */
  readonly ends: Uint16Array;
  readonly endTicks: Float64Array;
  /** Number of threads that have ended so far, and where they ended last along x, m. */
  endedCount = 0;
  lastX = 0;
  readonly #world: PhysicsWorld;
  readonly #cloth: Cloth;
  /** x, y and z of all nodes, frame after frame, and the tick of each frame: a ring, −1 where there is none. */
  readonly #frames: Float32Array;
  readonly #frameTicks = new Float64Array(MAX_FRAMES).fill(-1);
  /** The tick that was recorded last, and the last tear: ticks of its first and its last thread, and their number. */
  readonly #last = { tick: -1, threads: 0, from: -1, to: -1, ended: 0 };
  #isFrozen = false;

  /** Adds a system to the `finish` phase, after the one that takes broken threads out. */
  constructor(world: PhysicsWorld, cloth: Cloth) {
    this.#world = world;
    this.#cloth = cloth;
    const { Spring } = world.components;
    const [first] = cloth.nodes;
    this.ends = Uint16Array.from({ length: 2 * cloth.springs.length }, (_, i) => {
      const end = i % 2 === 0 ? Spring.a : Spring.b;
      return end[cloth.springs[i >> 1]] - first;
    });
    this.endTicks = new Float64Array(cloth.springs.length).fill(Number.POSITIVE_INFINITY);
    this.#frames = new Float32Array(3 * cloth.nodes.length * MAX_FRAMES);
    this.#last.threads = cloth.springs.length;
    world.phases.finish.push(() => this.#record());
  }

  get nodeCount(): number {
    return this.#cloth.nodes.length;
  }

  /** The last tear, some moments after its last thread has ended and as long as the record reaches back to it. */
  get tear(): Tear | undefined {
    const { tick, from, to, ended } = this.#last;
    if (ended < MIN_ENDED || tick < to + LEAD_OUT) return undefined;
    let oldest = Number.POSITIVE_INFINITY;
    for (const each of this.#frameTicks) if (each >= 0) oldest = Math.min(oldest, each);
    return oldest < to ? { from: Math.max(oldest, from - LEAD_IN), to: to + LEAD_OUT } : undefined;
  }

  /** While it is frozen the record keeps what it has. Afterwards it begins anew, and the tear has been watched. */
  set isFrozen(on: boolean) {
    if (this.#isFrozen && !on) {
      this.#frameTicks.fill(-1);
      this.#last.ended = 0;
    }
    this.#isFrozen = on;
  }

  /**
   * Positions of all nodes at a time in steps, between two frames if need be.
   * @param out receives x, y and z of each node @returns whether the record has that time
   */
  positionsAt(time: number, out: Float32Array): boolean {
    const frame = Math.floor(time / FRAME_STEPS);
    const [a, b] = [this.#offsetOf(frame), this.#offsetOf(frame + 1)];
    if (a === undefined) return false;
    const share = b === undefined ? 0 : time / FRAME_STEPS - frame;
    const next = b ?? a;
    for (let i = 0; i < out.length; i++) {
      const value = this.#frames[a + i];
      out[i] = value + (this.#frames[next + i] - value) * share;
    }
    return true;
  }

  /** Number of threads that held at a time in steps. */
  threadsAt(time: number): number {
    let count = 0;
    for (let i = 0; i < this.endTicks.length; i++) if (this.endTicks[i] > time) count++;
    return count;
  }

  #offsetOf(frame: number): number | undefined {
    const place = frame % MAX_FRAMES;
    return this.#frameTicks[place] === frame * FRAME_STEPS ? 3 * this.nodeCount * place : undefined;
  }

  #record(): void {
    const { tick, components } = this.#world;
    if (tick <= this.#last.tick) this.#goBack(tick);
    this.#last.tick = tick;
    const threads = query(this.#world, [components.Spring]).length;
    if (threads !== this.#last.threads) this.#noteEnded(tick);
    this.#last.threads = threads;
    if (tick % FRAME_STEPS === 0 && !this.#isFrozen) this.#addFrame(tick);
  }

  /** After a rewind, what was recorded later has not happened. */
  #goBack(tick: number): void {
    const last = this.#last;
    for (let i = 0; i < this.endTicks.length; i++) {
      if (this.endTicks[i] >= tick) this.endTicks[i] = Number.POSITIVE_INFINITY;
    }
    for (let i = 0; i < MAX_FRAMES; i++) if (this.#frameTicks[i] >= tick) this.#frameTicks[i] = -1;
    last.threads = this.threadsAt(tick);
    if (last.to >= tick) last.ended = 0;
  }

  #noteEnded(tick: number): void {
    const { springs, nodes } = this.#cloth;
    const { x } = this.#world.components.Position;
    const last = this.#last;
    if (tick > last.to + LEAD_OUT || last.ended === 0) Object.assign(last, { from: tick, ended: 0 });
    for (let i = 0; i < springs.length; i++) {
      if (this.endTicks[i] !== Number.POSITIVE_INFINITY || entityExists(this.#world, springs[i])) continue;
      this.endTicks[i] = tick;
      this.endedCount++;
      last.ended++;
      this.lastX = x[nodes[this.ends[2 * i]]];
    }
    last.to = tick;
  }

  #addFrame(tick: number): void {
    const place = (tick / FRAME_STEPS) % MAX_FRAMES;
    const { x, y, z } = this.#world.components.Position;
    const [first] = this.#cloth.nodes;
    const offset = 3 * this.nodeCount * place;
    for (let i = 0; i < this.nodeCount; i++) {
      this.#frames[offset + 3 * i] = x[first + i];
      this.#frames[offset + 3 * i + 1] = y[first + i];
      this.#frames[offset + 3 * i + 2] = z[first + i];
    }
    this.#frameTicks[place] = tick;
  }
}
