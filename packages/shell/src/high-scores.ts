import { browserStore, type LocalStore, readLocal, writeLocal } from './local-store.ts';

/** A score reached in this browser. */
export interface HighScore {
  /** Above 0. */
  readonly score: number;
  /** Date in the form 2001-12-31. */
  readonly day: string;
}

const MAX_SCORES = 5;

/** The five best scores of a game in the browser's storage; without storage they last as long as the page. */
export class HighScores {
  readonly #key: string;
  readonly #storage: LocalStore | undefined;
  #list: readonly HighScore[];

  /** @param game name under which the scores are stored @param storage default `localStorage`, where the browser allows it */
  constructor(game: string, storage: LocalStore | undefined = browserStore()) {
    this.#key = `principia scores: ${game}`;
    this.#storage = storage;
    this.#list = this.#read();
  }

  /** Sorted from best to worst. */
  get list(): readonly HighScore[] {
    return this.#list;
  }

  /** The best score; 0 while there is none. */
  get best(): number {
    return this.#list[0]?.score ?? 0;
  }

  /** Adds a score. @returns its index in the list, −1 if it is not among the best or not above 0 */
  add(score: number, day: string): number {
    if (!(score > 0 && Number.isFinite(score))) return -1;
    const entry = { score, day };
    const list = [...this.#list, entry].sort((a, b) => b.score - a.score).slice(0, MAX_SCORES);
    this.#list = list;
    writeLocal(this.#storage, this.#key, list);
    return list.indexOf(entry);
  }

  /** Invalid data under the same name is ignored. */
  #read(): readonly HighScore[] {
    const found = readLocal(this.#storage, this.#key);
    if (!Array.isArray(found)) return [];
    const scores = found.filter((entry) => Number.isFinite(entry?.score) && typeof entry.day === 'string');
    return scores.sort((a, b) => b.score - a.score).slice(0, MAX_SCORES);
  }
}
