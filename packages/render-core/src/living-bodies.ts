import type { BodySource } from './body-source.ts';

/**
 * Which ids of a source have a body. Ids are reused, so who keeps an id compares its generation as well: see
 * `BodySource.generations`.
 */
export class LivingBodies {
  readonly #source: BodySource;
  /** Per id, the number of the last refresh that found a body. */
  readonly #found: Uint32Array;
  #refreshes = 0;
  #membership = Number.NaN;

  constructor(source: BodySource) {
    this.#source = source;
    this.#found = new Uint32Array(source.rows);
  }

  /** Looks through the bodies if they may have changed since the last call. Returns whether it did. */
  refresh(): boolean {
    const { membership } = this.#source.versions;
    if (membership === this.#membership) return false;
    this.#membership = membership;
    this.#refreshes++;
    const { ids, count } = this.#source;
    for (let i = 0; i < count; i++) this.#found[ids[i]] = this.#refreshes;
    return true;
  }

  /** Whether there was a body with this id at the last refresh. */
  has(id: number): boolean {
    return this.#found[id] === this.#refreshes;
  }

  /** The generation of an id, see `BodySource.generations`; 0 where the source has none. */
  generationOf(id: number): number {
    return this.#source.generations?.[id] ?? 0;
  }
}
