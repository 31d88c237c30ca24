// A ring buffer of events for sound and display; records are reused.

/** An audible event. */
export interface FireworksEvent {
  type: 'launch' | 'burst' | 'crackle';
  x: number;
  y: number;
  z: number;
  /** World time, s. */
  time: number;
  /** Index of the shell kind and of its colour. */
  kind: number;
  color: number;
  /** 0 to 1. */
  power: number;
}

const CAPACITY = 256;

/** The last events, for sound and display. */
export class EventRing {
  /** Number of events so far; the last 256 can be read. */
  count = 0;
  readonly #items: FireworksEvent[] = Array.from({ length: CAPACITY }, () => ({
    type: 'launch',
    x: 0,
    y: 0,
    z: 0,
    time: 0,
    kind: 0,
    color: 0,
    power: 0,
  }));

  /** Event number `index` from 0; read it immediately, because it will be overwritten. */
  at(index: number): FireworksEvent {
    return this.#items[index % CAPACITY];
  }

  /** The next record, to be filled in. */
  next(): FireworksEvent {
    return this.#items[this.count++ % CAPACITY];
  }
}
