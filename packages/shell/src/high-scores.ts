/** A score somebody reached on this machine. */
export interface HighScore {
  readonly score: number;
  /** Day it was reached, as 2001-12-31. */
  readonly day: string;
}

/** The part of `localStorage` that scores need. */
export type ScoreStorage = Pick<Storage, 'getItem' | 'setItem'>;

const KEPT = 5;

/** The best scores of a game, kept by the browser; where it keeps nothing, they last as long as the page. */
export class HighScores {
  readonly #key: string;
  readonly #storage: ScoreStorage | undefined;
  #list: readonly HighScore[];

  /** @param game name the scores are kept under */
  constructor(game: string, storage: ScoreStorage | undefined = browserStorage()) {
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
    try {
      this.#storage?.setItem(this.#key, JSON.stringify(list));
    } catch {
      // The browser's store is full or closed to us: the scores of this page still count.
    }
    return list.indexOf(entry);
  }

  /** What somebody else wrote under the same name is not worth an error. */
  #read(): readonly HighScore[] {
    try {
      const found: unknown = JSON.parse(this.#storage?.getItem(this.#key) ?? '[]');
      if (!Array.isArray(found)) return [];
      const scores = found.filter((entry) => Number.isFinite(entry?.score) && typeof entry.day === 'string');
      return scores.sort((a, b) => b.score - a.score).slice(0, KEPT);
    } catch {
      return [];
    }
  }
}

/** Some browsers throw at the mere mention where pages may keep nothing. */
function browserStorage(): ScoreStorage | undefined {
  try {
    return globalThis.localStorage;
  } catch {
    return undefined;
  }
}
