import { KeptValue } from './kept-value.ts';
import type { LocalStore } from './local-store.ts';

/** A score reached in this browser. */
export interface HighScore {
  /** Above 0. */
  readonly score: number;
  /** Date in the form 2001-12-31, in the player's time zone. */
  readonly day: string;
}

const MAX_SCORES = 5;

/** The five best scores of a game in the browser's storage; without storage they last as long as the page. */
export class HighScores {
  readonly #kept: KeptValue<readonly HighScore[]>;

  /** @param game name under which the scores are stored @param storage default `localStorage`, where the browser allows it */
  constructor(game: string, storage?: LocalStore) {
    this.#kept = new KeptValue(`principia scores: ${game}`, scoresIn, storage);
  }

  /** Sorted from best to worst. */
  get list(): readonly HighScore[] {
    return this.#kept.value;
  }

  /** The best score; 0 while there is none. */
  get best(): number {
    return this.list[0]?.score ?? 0;
  }

  /** Adds a score. @returns its index in the list, −1 if it is not among the best or not above 0 */
  add(score: number, day: string): number {
    if (!(score > 0 && Number.isFinite(score))) return -1;
    const entry = { score, day };
    this.#kept.change((list) => best([...list, entry]));
    return this.list.indexOf(entry);
  }
}

/** Invalid data under the same name is ignored. */
function scoresIn(found: unknown): readonly HighScore[] {
  if (!Array.isArray(found)) return [];
  return best(found.filter((entry) => Number.isFinite(entry?.score) && typeof entry.day === 'string'));
}

function best(scores: readonly HighScore[]): readonly HighScore[] {
  return scores.toSorted((a, b) => b.score - a.score).slice(0, MAX_SCORES);
}
