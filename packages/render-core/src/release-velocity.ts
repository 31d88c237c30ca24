/** Number of samples; at 120 pointer events a second they cover more than `WINDOW_SECONDS`. */
const SAMPLES = 16;

/** Time window of the estimate, s: long enough to average out jitter, short enough to feel immediate. */
const WINDOW_SECONDS = 0.08;

/**
 * Longest time between two samples that count as one motion, s. Browsers deliver pointer events once a frame, so a slow
 * page samples a pointer ten times a second although the pointer never rests.
 */
const MAX_INTERVAL_SECONDS = 0.12;

/**
 * Estimates the velocity of a pointer just before its release from its latest positions. A pointer at rest before the
 * release has zero velocity.
 */
export class ReleaseVelocity {
  readonly #t = new Float64Array(SAMPLES);
  readonly #x = new Float64Array(SAMPLES);
  readonly #y = new Float64Array(SAMPLES);
  #count = 0;
  /** The estimate made by the latest `estimate`, in the unit of the samples per second. */
  x = 0;
  y = 0;

  /** Discards all samples. */
  reset(): void {
    this.#count = 0;
    this.x = 0;
    this.y = 0;
  }

  /** Adds a position. @param time seconds, not decreasing */
  add(time: number, x: number, y: number): void {
    const i = this.#count++ % SAMPLES;
    this.#t[i] = time;
    this.#x[i] = x;
    this.#y[i] = y;
  }

  /**
   * Computes the mean velocity over the last 80 ms of samples, or over the last two samples where they lie further
   * apart, into `x` and `y`. @param time of the release, seconds
   */
  estimate(time: number): void {
    this.x = 0;
    this.y = 0;
    if (this.#count < 2) return;
    const newest = (this.#count - 1) % SAMPLES;
    const interval = this.#t[newest] - this.#t[(this.#count - 2) % SAMPLES];
    if (interval > MAX_INTERVAL_SECONDS) return;
    // A pointer rests if no sample came for longer than the window, and for longer than between the last two.
    if (time - this.#t[newest] > Math.max(WINDOW_SECONDS, interval)) return;
    let oldest = newest;
    const reach = Math.min(this.#count, SAMPLES);
    for (let back = 1; back < reach; back++) {
      const i = (this.#count - 1 - back) % SAMPLES;
      if (back > 1 && this.#t[newest] - this.#t[i] > WINDOW_SECONDS) break;
      oldest = i;
    }
    const dt = this.#t[newest] - this.#t[oldest];
    if (dt <= 0) return;
    this.x = (this.#x[newest] - this.#x[oldest]) / dt;
    this.y = (this.#y[newest] - this.#y[oldest]) / dt;
  }
}
