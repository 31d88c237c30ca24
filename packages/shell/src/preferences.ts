import { browserStore, type LocalStore, readLocal, writeLocal } from './local-store.ts';

/** The player's appearance settings for all games. */
export interface AppearanceOptions {
  /** As little motion as possible: no camera shake, no decorative sparks or animations. */
  readonly reducedMotion: boolean;
  /** Uses colours that people with any kind of colour vision can distinguish. */
  readonly safeColors: boolean;
}

const STORE_KEY = 'principia appearance';

/** The player's choices in the browser's storage; until a choice is made, reduced motion follows the system setting. */
export class Preferences implements AppearanceOptions {
  readonly #store: LocalStore | undefined;
  #options: AppearanceOptions;
  /** The player has not chosen: the system decides. */
  #followsMotion: boolean;

  constructor(systemReducesMotion: boolean, store: LocalStore | undefined = browserStore()) {
    this.#store = store;
    const found = readLocal(store, STORE_KEY) as Partial<Record<keyof AppearanceOptions, unknown>> | undefined;
    const chosen = (name: keyof AppearanceOptions, otherwise: boolean) => {
      const value = found?.[name];
      return typeof value === 'boolean' ? value : otherwise;
    };
    this.#followsMotion = typeof found?.reducedMotion !== 'boolean';
    this.#options = {
      reducedMotion: chosen('reducedMotion', systemReducesMotion),
      safeColors: chosen('safeColors', false),
    };
  }

  get reducedMotion(): boolean {
    return this.#options.reducedMotion;
  }

  get safeColors(): boolean {
    return this.#options.safeColors;
  }

  /** Follows the system, which has changed, if the player has not chosen. @returns whether this changes anything */
  follow(systemReducesMotion: boolean): boolean {
    if (!this.#followsMotion || systemReducesMotion === this.reducedMotion) return false;
    this.#options = { ...this.#options, reducedMotion: systemReducesMotion };
    return true;
  }

  set(changes: Partial<AppearanceOptions>): void {
    this.#followsMotion &&= changes.reducedMotion === undefined;
    this.#options = { ...this.#options, ...changes };
    const { safeColors } = this.#options;
    writeLocal(this.#store, STORE_KEY, this.#followsMotion ? { safeColors } : this.#options);
  }
}

/**
 * Eight colours, without black, that any kind of colour vision can distinguish: Okabe and Ito, Color Universal Design
 * (2008). As 0xRRGGBB.
 */
export const SAFE_COLORS: readonly number[] = [
  0xe69f00, 0x56b4e9, 0x009e73, 0xf0e442, 0x0072b2, 0xd55e00, 0xcc79a7, 0xffffff,
];
