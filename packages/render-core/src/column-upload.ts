import type { RealColumn } from './body-source.ts';

/** Texels in a row of a data texture; a column's length is a multiple of it. */
export const TEXTURE_WIDTH = 1024;

/**
 * Converts a column of a world into the `Float32Array` that a graphics API accepts.
 *
 * An f32 column is used directly, without a copy. An f64 column gets an f32 copy, optionally relative to an origin: a
 * body 10⁹ m from zero keeps millimetre precision if the origin is near it, because the subtraction is done in f64.
 */
export class ColumnUpload {
  #shadow: Float32Array | undefined;
  #data: Float32Array = EMPTY;
  #origin = 0;

  /** The array to upload. Replaced only when the column itself was replaced; valid after the first `refresh`. */
  get data(): Float32Array {
    return this.#data;
  }

  /** The offset to add to `data` to get world coordinates, metres; always zero for an f32 column. */
  get origin(): number {
    return this.#origin;
  }

  /**
   * Updates `data`. Free for an f32 column; 0.8 ns per value for an f64 column.
   *
   * @param column the world's column, any length
   * @param length number of leading values that are needed; the rest of `data` may be stale
   * @param origin subtracted from an f64 column before rounding, in the column's unit; ignored for f32 columns, whose
   * precision is already lost
   * @returns `data`
   */
  refresh(column: RealColumn, length: number, origin = 0): Float32Array {
    if (column instanceof Float32Array) {
      this.#data = column;
      this.#origin = 0;
      return column;
    }
    let shadow = this.#shadow;
    if (shadow === undefined || shadow.length !== column.length) {
      shadow = new Float32Array(column.length);
      this.#shadow = shadow;
    }
    const end = Math.min(length, column.length);
    for (let i = 0; i < end; i++) shadow[i] = column[i] - origin;
    this.#data = shadow;
    this.#origin = origin;
    return shadow;
  }

  /** Replaces the column by another one with the values of the last `refresh`. */
  replaceColumn(column: RealColumn): Float32Array {
    if (column instanceof Float32Array) this.#data = column;
    return this.#data;
  }
}

const EMPTY = new Float32Array(0);

/** Limit of unused rows, because every upload includes them. */
const MAX_SPARE_ROWS = 8;

/**
 * Computes the number of rows of a data texture. It keeps uploads close to the used size while a fluctuating population
 * does not re-create the texture every frame: it grows by a quarter more than needed, at most 8 rows, and shrinks only
 * when less than a quarter is used.
 *
 * @param used number of values in use, from the start of the array
 * @param current present rows of the texture; zero before the first call
 * @param length length of the array behind the texture, a multiple of `TEXTURE_WIDTH`
 * @returns rows, at least one and never more than the array fills
 * @throws Error when the array is not a whole number of rows
 */
export function textureRows(used: number, current: number, length: number): number {
  if (length === 0 || length % TEXTURE_WIDTH !== 0) {
    throw new Error(
      `a column to draw must have a length that is a positive multiple of ${TEXTURE_WIDTH}, got ${length}: round the world's capacity up`,
    );
  }
  const needed = Math.max(1, Math.ceil(used / TEXTURE_WIDTH));
  if (needed <= current && needed * 4 >= current) return current;
  return Math.min(length / TEXTURE_WIDTH, needed + Math.min(needed >> 2, MAX_SPARE_ROWS));
}
