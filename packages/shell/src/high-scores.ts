import { browserStore, type LocalStore, readLocal, writeLocal } from './local-store.ts';

/** A score somebody reached on this machine. */
export interface HighScore {
  readonly score: number;
  /** Day it was reached, as 2001-12-31. */
  readonly day: string;
}

const KEPT = 5;

/** The best scores of a game, kept by the browser; where it keeps nothing, they last as long as the page. */
export class HighScores {
  readonly #key: string;
  readonly #storage: LocalStore | undefined;
  #list: readonly HighScore[];

  /** @param game name the scores are kept under */
  constructor(game: string, storage: LocalStore | undefined = browserStore()) {
    this.#key = `principia scores: ${game}`;
    this.#storage = storage;
    this.#list = this.#read();
  }

  /** Best first. */
  get list(): readonly HighScore[] {
    return this.#list;
  }

  get best(): number {
    return this.#list[0]?.score ?? 0;
  }

  /** Notes a score. @returns its place in the list, from zero; −1 where it is not among the best */
  add(score: number, day: string): number {
    if (!(score > 0 && Number.isFinite(score))) return -1;
    const entry = { score, day };
    const list = [...this.#list, entry].sort((a, b) => b.score - a.score).slice(0, KEPT);
    this.#list = list;
    writeLocal(this.#storage, this.#key, list);
    return list.indexOf(entry);
  }

  /** What somebody else wrote under the same name is not worth an error. */
  #read(): readonly HighScore[] {
    const found = readLocal(this.#storage, this.#key);
    if (!Array.isArray(found)) return [];
    const scores = found.filter((entry) => Number.isFinite(entry?.score) && typeof entry.day === 'string');
    return scores.sort((a, b) => b.score - a.score).slice(0, KEPT);
  }
}
