// What happened, for ears and eyes: a ring of records that are written again and again.

/** Something that can be heard. */
export interface SkyNews {
  what: 'launch' | 'burst' | 'crackle';
  x: number;
  y: number;
  z: number;
  /** World time, s. */
  time: number;
  /** Number of the shell kind and of its colour. */
  kind: number;
  color: number;
  /** 0 to 1. */
  power: number;
}

const MOST = 256;

export class NewsRing {
  /** How many there ever were; the last 256 can be read. */
  count = 0;
  readonly #items: SkyNews[] = Array.from({ length: MOST }, () => ({
    what: 'launch',
    x: 0,
    y: 0,
    z: 0,
    time: 0,
    kind: 0,
    color: 0,
    power: 0,
  }));

  /** The record of number `index`, from 0; read it at once, as it will be written again. */
  at(index: number): SkyNews {
    return this.#items[index % MOST];
  }

  /** The next record, to be filled in. */
  next(): SkyNews {
    return this.#items[this.count++ % MOST];
  }
}
