/** Samples of several quantities over a whole run. When the memory is full, every second sample goes. */
export class Samples {
  readonly #columns: number[][];
  readonly #capacity: number;
  /** Shortest time between two samples, s. */
  #interval: number;

  /** @param quantities besides the time @param interval shortest time between two samples, s */
  constructor(quantities: number, interval: number, capacity = 1200) {
    this.#columns = Array.from({ length: quantities + 1 }, () => []);
    this.#interval = interval;
    this.#capacity = capacity;
  }

  /** The times, then the values of each quantity. */
  get columns(): readonly (readonly number[])[] {
    return this.#columns;
  }

  isDue(time: number): boolean {
    const last = this.#columns[0].at(-1);
    return last === undefined || time >= last + 0.999 * this.#interval;
  }

  add(time: number, values: readonly number[]): void {
    const columns = this.#columns;
    if (columns[0].length >= this.#capacity) this.#thin();
    columns[0].push(time);
    for (const [i, value] of values.entries()) columns[i + 1].push(value);
  }

  /** Index of the last sample not after a time; −1 before the first, and for a time that is not a number. */
  lastBefore(time: number): number {
    const [times] = this.#columns;
    let index = Number.isNaN(time) ? -1 : times.length - 1;
    while (index >= 0 && times[index] > time) index--;
    return index;
  }

  /** Discards samples after a time, as after a rewind. @returns whether there were any */
  discardAfter(time: number): boolean {
    const [times] = this.#columns;
    let count = times.length;
    while (count > 0 && times[count - 1] > time) count--;
    if (count === times.length) return false;
    for (const column of this.#columns) column.length = count;
    return true;
  }

  #thin(): void {
    this.#interval *= 2;
    for (const column of this.#columns) {
      for (let i = 0; 2 * i < column.length; i++) column[i] = column[2 * i];
      column.length = Math.ceil(column.length / 2);
    }
  }
}
