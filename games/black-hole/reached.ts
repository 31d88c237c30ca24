/** The highest level that the player has reached, in the browser's storage; without storage it lasts as long as the page. */
import { BLACK_HOLE } from '@principia/scenes';
import { browserStore, type LocalStore, readLocal, writeLocal } from '@principia/shell';
import type { BlackHoleGame } from './sim.ts';

const STORE_KEY = 'principia black hole level';

export class ReachedLevel {
  readonly #store: LocalStore | undefined;
  /** Level that the address of the page asks for: a link to a level opens it. */
  readonly #linked: number;
  #level: number;

  /** @param query of the page's address */
  constructor(query: string, store: LocalStore | undefined = browserStore()) {
    this.#store = store;
    this.#linked = levelFrom(Number(new URLSearchParams(query).get('level')));
    this.#level = levelFrom(readLocal(store, STORE_KEY));
  }

  /** The highest level at which a game may begin. */
  get highest(): number {
    return Math.max(this.#level, this.#linked);
  }

  /** Notes the level that a flight to the goal opened, if the player flew it. */
  note({ rules, isDemo, isReplay, autopilot }: BlackHoleGame): void {
    const level = levelFrom(rules.level);
    if (isDemo || isReplay || autopilot || level <= this.#level) return;
    this.#level = level;
    writeLocal(this.#store, STORE_KEY, level);
  }
}

/** Anything that is no level counts as the first. */
function levelFrom(value: unknown): number {
  return Number.isInteger(value) && (value as number) >= 1 && (value as number) <= BLACK_HOLE.most
    ? (value as number)
    : 1;
}
