/** Values of several series at the last steps, in arrays of fixed size. */
export class SeriesHistory {
  /** Twice as long as what is kept: only when they are full do the last rows move to their beginning. */
  readonly #ticks: Float64Array;
  readonly #times: Float64Array;
  readonly #columns: readonly Float64Array[];
  #capacity: number;
  #start = 0;
  #end = 0;

  /** @param series values per row @param capacity rows kept */
  constructor(series: number, capacity: number) {
    this.#capacity = capacity;
    this.#ticks = new Float64Array(2 * capacity);
    this.#times = new Float64Array(2 * capacity);
    this.#columns = Array.from({ length: series }, () => new Float64Array(2 * capacity));
  }

  get count(): number {
    return this.#end - this.#start;
  }

  /** @param tick number of the step; higher than that of the row before */
  add(tick: number, time: number, values: ArrayLike<number>): void {
    if (this.#end === this.#times.length) this.#moveToBeginning();
    this.#ticks[this.#end] = tick;
    this.#times[this.#end] = time;
    for (let i = 0; i < this.#columns.length; i++) this.#columns[i][this.#end] = values[i];
    this.#end++;
    if (this.count > this.#capacity) this.#start++;
  }

  #moveToBeginning(): void {
    const { count } = this;
    this.#ticks.copyWithin(0, this.#start, this.#end);
    this.#times.copyWithin(0, this.#start, this.#end);
    for (const column of this.#columns) column.copyWithin(0, this.#start, this.#end);
    this.#start = 0;
    this.#end = count;
  }

  /** Discards the rows of a step and of those after it, for example after a rewind. @returns whether there were any */
  discardFrom(tick: number): boolean {
    const before = this.#end;
    while (this.#end > this.#start && this.#ticks[this.#end - 1] >= tick) this.#end--;
    return this.#end < before;
  }

  /** Keeps of the rows those of every so many steps, and as many from now on as given. */
  thin(stride: number, capacity: number): void {
    let kept = 0;
    for (let i = this.#start; i < this.#end; i++) {
      if (this.#ticks[i] % stride !== 0) continue;
      this.#ticks[kept] = this.#ticks[i];
      this.#times[kept] = this.#times[i];
      for (const column of this.#columns) column[kept] = column[i];
      kept++;
    }
    this.#capacity = Math.min(capacity, this.#capacity);
    this.#end = kept;
    this.#start = Math.max(0, kept - this.#capacity);
  }

  /** Index of the last row not after a time; −1 before the first, and for a time that is not a number. */
  lastBefore(time: number): number {
    let index = Number.isNaN(time) ? -1 : this.count - 1;
    while (index >= 0 && this.#times[this.#start + index] > time) index--;
    return index;
  }

  /** Discards all rows, and what `thin` said. */
  clear(): void {
    this.#capacity = this.#times.length / 2;
    this.#start = 0;
    this.#end = 0;
  }

  /** The times and the columns of the rows. */
  data(): [Float64Array, ...Float64Array[]] {
    return [this.#times, ...this.#columns].map((column) => column.subarray(this.#start, this.#end)) as never;
  }
}
