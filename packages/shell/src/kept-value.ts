import { browserStore, type LocalStore, readLocal, writeLocal } from './local-store.ts';

/**
 * A value that the browser keeps, also for other tabs with the same game; where it keeps nothing, the value lasts as long as the
 * page.
 */
export class KeptValue<T> {
  readonly #name: string;
  readonly #check: (found: unknown) => T;
  readonly #store: LocalStore | undefined;
  #value: T;
  /** The last value could not be stored, so what the storage has is older. */
  #isUnsaved = false;

  /**
   * @param check makes a value of what was found: undefined where there is nothing, or anything that somebody else wrote
   * @param store default `localStorage`, where the browser allows it
   */
  constructor(name: string, check: (found: unknown) => T, store: LocalStore | undefined = browserStore()) {
    this.#name = name;
    this.#check = check;
    this.#store = store;
    this.#value = this.#read();
  }

  /** As this page read or wrote it last. */
  get value(): T {
    return this.#value;
  }

  /** Changes what the storage has by now: another tab may have written since. */
  change(change: (now: T) => T): void {
    this.#value = change(this.#isUnsaved ? this.#value : this.#read());
    this.#isUnsaved = !writeLocal(this.#store, this.#name, this.#value);
  }

  #read(): T {
    return this.#check(readLocal(this.#store, this.#name));
  }
}
