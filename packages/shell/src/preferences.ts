import { browserStore, type LocalStore, readLocal, writeLocal } from './local-store.ts';

/** How somebody wants every game to look. */
export interface Looks {
  /** As little motion as possible: no shaking, no flying sparks, no animation that shows nothing. */
  readonly calm: boolean;
  /** Colours that people with any kind of colour vision tell apart. */
  readonly safeColors: boolean;
}

const NAME = 'principia looks';

/** What the player chose, kept by the browser for all games; until then calm is what the system asks for. */
export class Preferences implements Looks {
  readonly #store: LocalStore | undefined;
  #looks: Looks;

  constructor(systemIsCalm: boolean, store: LocalStore | undefined = browserStore()) {
    this.#store = store;
    const found = readLocal(store, NAME) as Partial<Record<keyof Looks, unknown>> | undefined;
    const chosen = (name: keyof Looks, otherwise: boolean) => {
      const value = found?.[name];
      return typeof value === 'boolean' ? value : otherwise;
    };
    this.#looks = { calm: chosen('calm', systemIsCalm), safeColors: chosen('safeColors', false) };
  }

  get calm(): boolean {
    return this.#looks.calm;
  }

  get safeColors(): boolean {
    return this.#looks.safeColors;
  }

  set(changes: Partial<Looks>): void {
    this.#looks = { ...this.#looks, ...changes };
    writeLocal(this.#store, NAME, this.#looks);
  }
}

/**
 * Eight colours that are told apart with any kind of colour vision, without black: Okabe and Ito, Color Universal
 * Design (2008). As 0xRRGGBB.
 */
export const SAFE_COLORS: readonly number[] = [
  0xe69f00, 0x56b4e9, 0x009e73, 0xf0e442, 0x0072b2, 0xd55e00, 0xcc79a7, 0xffffff,
];
