/** The highest level that the player has reached, in the browser's storage; without storage it lasts as long as the page. */
import { BLACK_HOLE } from '@principia/scenes';
import { KeptValue, type LocalStore } from '@principia/shell';
import type { BlackHoleGame } from './sim.ts';

const STORE_KEY = 'principia black hole level';

export class ReachedLevel {
  readonly #kept: KeptValue<number>;
  /** Level that the address of the page asks for: a link to a level opens it. */
  readonly #linked: number;

  /** @param query of the page's address */
  constructor(query: string, store?: LocalStore) {
    this.#kept = new KeptValue(STORE_KEY, levelFrom, store);
    this.#linked = levelFrom(Number(new URLSearchParams(query).get('level')));
  }

  /** The highest level at which a game may begin. */
  get highest(): number {
    return Math.max(this.#kept.value, this.#linked);
  }

  /** Notes the level that a flight to the goal opened, if the player flew it. */
  note({ rules, isDemo, isReplay, autopilot }: BlackHoleGame): void {
    const level = levelFrom(rules.level);
    if (isDemo || isReplay || autopilot || level <= this.#kept.value) return;
    this.#kept.change((now) => Math.max(now, level));
  }
}

/** Anything that is no level counts as the first. */
function levelFrom(value: unknown): number {
  return Number.isInteger(value) && (value as number) >= 1 && (value as number) <= BLACK_HOLE.most
    ? (value as number)
    : 1;
}
