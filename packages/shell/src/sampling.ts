/** Range of a plot, s: over time, and of one quantity against another. */
export const RANGES = { time: 12, path: 40 } as const;
/** Least and most rows of a plot: those of steps that are longer than a frame, and half a megabyte for three lines. */
const [LEAST_ROWS, MOST_ROWS] = [240, 24_000];
/**
 * Largest share of the world's time that reading may cost, unless it is done only so often, s, anyway: the energy of many
 * bodies that attract each other takes longer than their step.
 */
const [COST_SHARE, LONGEST] = [0.05, 0.05];
/** The cost is the mean over so many milliseconds of reading or, as clocks of browsers are coarse, so many reads. */
const [WINDOW_MS, WINDOW_READS] = [5, 64];
/** Of so many means the least counts: one that was interrupted, or ran cold code, says nothing of the next. */
const MEANS = 3;

/** Which steps of a world a plot has a row of: all, or, where these are too many or cost too much, one of so many. */
export class Sampling {
  /** A step has a row if its number is a multiple of it: rows are evenly spaced, whatever the frames are. */
  stride: number;
  readonly #dt: number;
  readonly #range: number;
  readonly #isGiven: boolean;
  readonly #means = new Float64Array(MEANS).fill(Number.POSITIVE_INFINITY);
  #windows = 0;
  #spent = 0;
  #reads = 0;

  /** @param dt step of the world, s @param interval time between two rows, s, that the game asks for */
  constructor(dt: number, range: keyof typeof RANGES, interval?: number) {
    if (interval !== undefined && !(interval > 0 && interval < Infinity)) {
      throw new Error(`plotInterval of a game must be a time above zero, s, got ${interval}`);
    }
    this.#dt = dt;
    this.#range = RANGES[range];
    this.#isGiven = interval !== undefined;
    const asked = interval === undefined ? this.#range / MOST_ROWS : interval;
    const steps = asked / dt;
    this.stride = Math.max(1, this.#isGiven ? Math.round(steps) : Math.ceil(steps - 1e-9));
  }

  /** Time between two rows, s. */
  get interval(): number {
    return this.stride * this.#dt;
  }

  /** Number of rows in the range of the plot. */
  get rows(): number {
    return Math.min(MOST_ROWS, Math.max(LEAST_ROWS, Math.ceil(this.#range / this.interval)));
  }

  /** @param cost what reading a row took, ms @returns whether the stride has become longer */
  spent(cost: number): boolean {
    this.#spent += cost;
    this.#reads++;
    if (this.#isGiven || (this.#spent < WINDOW_MS && this.#reads < WINDOW_READS)) return false;
    this.#means[this.#windows++ % MEANS] = this.#spent / this.#reads;
    this.#spent = 0;
    this.#reads = 0;
    const needed = Math.ceil(Math.min(...this.#means) / (1000 * COST_SHARE * this.#dt));
    // The means are infinite at first. A multiple of the present stride, so that the rows that stay are evenly spaced.
    const longest = Math.max(1, Math.round(LONGEST / this.#dt));
    if (this.#windows < MEANS || Math.min(needed, longest) <= this.stride) return false;
    this.stride = Math.ceil(Math.min(needed, longest) / this.stride) * this.stride;
    return true;
  }
}
