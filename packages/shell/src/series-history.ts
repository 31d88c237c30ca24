/** Samples of several series over the last seconds, in arrays of fixed size. */
export class SeriesHistory {
  readonly #times: Float64Array;
  readonly #columns: readonly Float64Array[];
  readonly #interval: number;
  #count = 0;

  /** @param series values per sample @param capacity samples kept @param interval shortest time between samples, s */
  constructor(series: number, capacity: number, interval: number) {
    this.#times = new Float64Array(capacity);
    this.#columns = Array.from({ length: series }, () => new Float64Array(capacity));
    this.#interval = interval;
  }

  get count(): number {
    return this.#count;
  }

  /** Whether a sample at `time` is due. */
  isDue(time: number): boolean {
    const last = this.#count === 0 ? Number.NEGATIVE_INFINITY : this.#times[this.#count - 1];
    return time >= last + this.#interval * 0.999;
  }

  add(time: number, values: ArrayLike<number>): void {
    const capacity = this.#times.length;
    const isFull = this.#count === capacity;
    if (isFull) this.#times.copyWithin(0, 1);
    else this.#count++;
    this.#times[this.#count - 1] = time;
    for (let i = 0; i < this.#columns.length; i++) {
      if (isFull) this.#columns[i].copyWithin(0, 1);
      this.#columns[i][this.#count - 1] = values[i];
    }
  }

  /** Discards samples later than `time`, for example after a rewind. @returns whether there were any */
  discardAfter(time: number): boolean {
    const before = this.#count;
    while (this.#count > 0 && this.#times[this.#count - 1] > time) this.#count--;
    return this.#count < before;
  }

  /** Index of the last sample not after a time; −1 before the first, and for a time that is not a number. */
  lastBefore(time: number): number {
    let index = Number.isNaN(time) ? -1 : this.#count - 1;
    while (index >= 0 && this.#times[index] > time) index--;
    return index;
  }

  clear(): void {
    this.#count = 0;
  }

  /** The times and the columns of the recorded samples. */
  data(): [Float64Array, ...Float64Array[]] {
    return [this.#times, ...this.#columns].map((column) => column.subarray(0, this.#count)) as never;
  }
}
