import type { BodySource, RealColumn } from './body-source.ts';
import { TEXTURE_WIDTH } from './column-upload.ts';
import { LivingBodies } from './living-bodies.ts';

/** The source and size of a trail history. */
export interface TrailOptions {
  /** The bodies, by `worldSource`. */
  source: BodySource;
  /** Points kept per body, at least 2. */
  length: number;
  /**
   * Ids of the bodies with trails, fixed for the lifetime of the history. A trail ends with its body: another one that
   * takes the id has none. Default every body of the source, which takes `length * source.rows` points of memory.
   */
  bodies?: ArrayLike<number>;
  /** Keep every n-th pose; default 1. */
  interval?: number;
  /** Point that recorded positions are relative to, metres; keeps precision in a large f64 world. Default zero. */
  origin?: {
    readonly x: number;
    readonly y: number;
    /** Default 0. */
    readonly z?: number;
  };
}

/** A birth that no recording reaches: the slot has no trail. */
const NEVER = 0x7fffffff;

/**
 * Ring of the last `length` positions of each body, laid out as data textures: `length` slices one below the other,
 * each `rowsPerSlice` rows of `TEXTURE_WIDTH` texels, so the point of slot `s` in slice `k` is texel `k * rowsPerSlice
 * * TEXTURE_WIDTH + s`. A step writes one slice, so it uploads one range of rows.
 *
 * A slot is the body's id, or its index in `bodies` if that list was given.
 */
export class TrailHistory {
  readonly source: BodySource;
  readonly length: number;
  readonly interval: number;
  /** Ids that have trails, or undefined when every body has one and a slot is an id. */
  readonly bodies: Uint32Array | undefined;
  readonly rowsPerSlice: number;
  /** Recorded coordinates, metres relative to `origin`; `z` is empty in a 2D world. */
  readonly x: Float32Array;
  readonly y: Float32Array;
  readonly z: Float32Array;
  /** Index of the first recording of the body that now has each slot; older points belong to another body. */
  readonly birth: Uint32Array;
  /** Point the recorded coordinates are relative to, metres. Change it with `setOrigin`. */
  readonly origin: { x: number; y: number; z: number };
  /** Number of recordings so far; the newest has index `recordings - 1` and lies in slice `newestSlice`. */
  recordings = 0;
  newestSlice = 0;
  /** True when the newest recording is the source's current pose, false when the interval skipped it. */
  newestIsCurrent = false;
  /** Incremented when `birth` changed. */
  birthVersion = 0;
  /** Incremented when all slices changed and must be uploaded again. */
  resetVersion = 0;
  readonly #living: LivingBodies;
  /** Per slot, the number of the last search for changes that found its body, and the generation of that one. */
  readonly #found: Uint32Array;
  readonly #generations: Uint32Array;
  #searches = 1;
  #posesSinceRecording: number;
  #restored: number | undefined;

  /** @throws Error where `length`, `interval` or one of `bodies` is out of range */
  constructor(options: TrailOptions) {
    const { source, length, bodies, interval = 1, origin } = options;
    if (!Number.isInteger(length) || length < 2) {
      throw new Error(`trail length must be a whole number of points, at least 2, got ${length}`);
    }
    if (!Number.isInteger(interval) || interval < 1) {
      throw new Error(`trail interval must be a whole number of steps, at least 1, got ${interval}`);
    }
    this.source = source;
    this.length = length;
    this.interval = interval;
    this.bodies = bodies === undefined ? undefined : checkedIds(bodies, source.rows);
    this.rowsPerSlice = Math.max(1, Math.ceil((bodies === undefined ? source.rows : bodies.length) / TEXTURE_WIDTH));
    const slots = this.rowsPerSlice * TEXTURE_WIDTH;
    this.x = new Float32Array(slots * length);
    this.y = new Float32Array(slots * length);
    this.z = new Float32Array(source.dimensions === 3 ? slots * length : 0);
    this.birth = new Uint32Array(slots);
    this.origin = { x: origin?.x ?? 0, y: origin?.y ?? 0, z: origin?.z ?? 0 };
    this.#living = new LivingBodies(source);
    this.#found = new Uint32Array(slots);
    this.#generations = new Uint32Array(slots);
    this.bodies?.forEach((id, slot) => {
      this.#generations[slot] = this.#living.generationOf(id);
    });
    this.#posesSinceRecording = interval;
    this.#restored = source.versions.restored;
  }

  /**
   * Records the source's current pose. Call it once for every value of `source.versions.pose`. After an earlier state came back
   * all trails begin anew, as their points would lie in its future.
   *
   * @returns true when a slice was written, false when the interval skips this pose
   */
  record(): boolean {
    const { restored } = this.source.versions;
    if (restored !== this.#restored) this.clear();
    this.#restored = restored;
    // Between two recordings, too: the line to the place of a body that is gone would be drawn until the next one.
    if (this.#living.refresh()) this.#findBirths();
    this.#posesSinceRecording++;
    this.newestIsCurrent = this.#posesSinceRecording >= this.interval;
    if (!this.newestIsCurrent) return false;
    this.#posesSinceRecording = 0;
    this.newestSlice = this.recordings % this.length;
    const { position, dimensions } = this.source;
    const start = this.newestSlice * this.rowsPerSlice * TEXTURE_WIDTH;
    this.#copy(this.x, start, position.x, this.origin.x);
    this.#copy(this.y, start, position.y, this.origin.y);
    if (dimensions === 3) this.#copy(this.z, start, position.z, this.origin.z);
    this.recordings++;
    return true;
  }

  /** Restarts the trail of body `id`, for example after a teleport. Does nothing for a body without a trail. */
  restart(id: number): void {
    const slot = this.bodies === undefined ? id : this.bodies.indexOf(id);
    if (slot < 0 || slot >= this.birth.length || this.birth[slot] === NEVER) return;
    this.birth[slot] = this.recordings;
    this.birthVersion++;
  }

  /** Discards all points. */
  clear(): void {
    for (let slot = 0; slot < this.birth.length; slot++) {
      if (this.birth[slot] !== NEVER) this.birth[slot] = this.recordings;
    }
    this.birthVersion++;
    this.#posesSinceRecording = this.interval;
  }

  /** Makes the recorded points relative to another origin, metres; `z` default 0. Costs one pass over all of them. */
  setOrigin(x: number, y: number, z = 0): void {
    shift(this.x, this.origin.x - x);
    shift(this.y, this.origin.y - y);
    shift(this.z, this.origin.z - z);
    this.origin.x = x;
    this.origin.y = y;
    this.origin.z = z;
    this.resetVersion++;
  }

  /** Number of bodies whose trails are drawn. */
  get count(): number {
    return this.bodies === undefined ? this.source.count : this.bodies.length;
  }

  #copy(target: Float32Array, start: number, column: RealColumn, origin: number): void {
    const { bodies, source } = this;
    if (bodies === undefined) {
      const end = Math.min(source.lastId + 1, column.length);
      for (let id = 0; id < end; id++) target[start + id] = column[id] - origin;
    } else {
      for (let slot = 0; slot < bodies.length; slot++) target[start + slot] = column[bodies[slot]] - origin;
    }
  }

  /** The trail of a body that came since the last search begins at the next recording, and that of one that left ends. */
  #findBirths(): void {
    const { bodies, count } = this;
    const { ids } = this.source;
    const living = this.#living;
    this.#searches++;
    let changed = false;
    for (let i = 0; i < count; i++) {
      const id = bodies === undefined ? ids[i] : bodies[i];
      const slot = bodies === undefined ? id : i;
      const generation = living.generationOf(id);
      const isKnown = this.#generations[slot] === generation;
      if (bodies !== undefined && !(isKnown && living.has(id))) {
        changed ||= this.birth[slot] !== NEVER;
        this.birth[slot] = NEVER;
        continue;
      }
      const stayed = isKnown && this.#found[slot] === this.#searches - 1;
      this.#found[slot] = this.#searches;
      this.#generations[slot] = generation;
      if (stayed) continue;
      this.birth[slot] = this.recordings;
      changed = true;
    }
    if (changed) this.birthVersion++;
  }
}

function checkedIds(bodies: ArrayLike<number>, rows: number): Uint32Array {
  for (let i = 0; i < bodies.length; i++) {
    const id = bodies[i];
    if (!Number.isInteger(id) || id < 0 || id >= rows) {
      throw new Error(`trail bodies[${i}] must be an entity id from 0 to ${rows - 1}, got ${id}`);
    }
  }
  return Uint32Array.from(bodies);
}

function shift(values: Float32Array, by: number): void {
  if (by === 0) return;
  for (let i = 0; i < values.length; i++) values[i] += by;
}
