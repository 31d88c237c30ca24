import { type BodySource, LivingBodies } from '@principia/render-core';
import { bufferLength } from './buffer-capacity.ts';

/** In place of both ids of a link that is not drawn. */
export const NO_LINK = 0xffffffff;

/** Links between bodies. One that has lost a body is not drawn, even if another body has taken the id. */
export class LinkList {
  /** Two ids for each link, or twice `NO_LINK`. Whole rows of a texture. */
  shown = new Uint32Array(0);
  readonly #rows: number;
  readonly #living: LivingBodies;
  /** The ids as they were set, and the generations that they had then. */
  #ids = new Uint32Array(0);
  #generations = new Uint32Array(0);
  #count = 0;

  constructor(source: BodySource) {
    this.#rows = source.rows;
    this.#living = new LivingBodies(source);
  }

  /** Number of links, those that are not drawn included. */
  get count(): number {
    return this.#count;
  }

  /**
   * Replaces the links by the first `count` of `pairs`.
   *
   * @throws Error when an id is none of the source, or `count` not a whole number from zero; the links then stay as they are
   */
  set(pairs: ArrayLike<number>, count: number): void {
    const length = 2 * bufferLength(count, this.shown.length / 2, 1);
    for (let i = 0; i < 2 * count; i++) checkId(pairs[i], i, this.#rows);
    if (length !== this.shown.length) {
      this.shown = new Uint32Array(length);
      this.#ids = new Uint32Array(length);
      this.#generations = new Uint32Array(length);
    }
    for (let i = 0; i < 2 * count; i++) {
      this.#ids[i] = pairs[i];
      this.#generations[i] = this.#living.generationOf(pairs[i]);
    }
    this.#count = count;
    this.#living.refresh();
    this.#show();
  }

  /** Looks whether links have lost a body, or have it back, since the last call. Returns whether `shown` may have changed. */
  refresh(): boolean {
    if (!this.#living.refresh()) return false;
    this.#show();
    return this.#count > 0;
  }

  #show(): void {
    for (let i = 0; i < 2 * this.#count; i += 2) {
      const isWhole = this.#isThere(i) && this.#isThere(i + 1);
      this.shown[i] = isWhole ? this.#ids[i] : NO_LINK;
      this.shown[i + 1] = isWhole ? this.#ids[i + 1] : NO_LINK;
    }
  }

  #isThere(i: number): boolean {
    const id = this.#ids[i];
    return this.#living.has(id) && this.#living.generationOf(id) === this.#generations[i];
  }
}

function checkId(id: number, i: number, rows: number): void {
  if (Number.isInteger(id) && id >= 0 && id < rows) return;
  throw new Error(`pairs[${i}] must be the id of a body, from 1 to ${rows - 1}, got ${id}`);
}
