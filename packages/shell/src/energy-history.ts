import type { Energy } from '@principia/physics';

/** The energies of the last moments, in arrays of one size for ever. */
export class EnergyHistory {
  readonly #columns: readonly Float64Array[];
  readonly #interval: number;
  #count = 0;

  /** @param capacity samples kept @param interval least simulated time between two, s */
  constructor(capacity: number, interval: number) {
    this.#columns = [0, 1, 2, 3].map(() => new Float64Array(capacity));
    this.#interval = interval;
  }

  get count(): number {
    return this.#count;
  }

  /** Whether a sample at `time` is due. */
  isDue(time: number): boolean {
    const last = this.#count === 0 ? Number.NEGATIVE_INFINITY : this.#columns[0][this.#count - 1];
    return time >= last + this.#interval * 0.999;
  }

  add(time: number, { kinetic, potential, total }: Energy): void {
    const sample = [time, kinetic, potential, total];
    const capacity = this.#columns[0].length;
    if (this.#count === capacity) for (const column of this.#columns) column.copyWithin(0, 1);
    else this.#count++;
    for (const [i, column] of this.#columns.entries()) column[this.#count - 1] = sample[i];
  }

  clear(): void {
    this.#count = 0;
  }

  /** Times, kinetic, potential and total energies of the samples there are. */
  data(): [Float64Array, Float64Array, Float64Array, Float64Array] {
    return this.#columns.map((column) => column.subarray(0, this.#count)) as never;
  }
}
