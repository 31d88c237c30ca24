/** A show in the making: shells on a timeline. Knows nothing of pages. */
import { LAST_TICK, MOST_CUES, tidy } from './show.ts';
import type { Cue } from './sim.ts';

/** Steps from one click to the next place on the timeline. */
export const BEAT = 36;

export class ShowEditor {
  /** In the order of their times. */
  cues: readonly Cue[];
  /** Where the next shell goes, steps. */
  cursor: number;
  /** Place of the chosen shell in `cues`; -1 for none. */
  chosen = -1;
  /** Grows with every change. */
  version = 0;
  readonly #past: (readonly Cue[])[] = [];

  constructor(cues: readonly Cue[] = []) {
    this.cues = cues;
    this.cursor = cues.length === 0 ? 0 : Math.min(LAST_TICK, cues[cues.length - 1].tick + BEAT);
  }

  /** A shell at the cursor, which goes on by a beat. @returns false when the show is full */
  add(shell: Omit<Cue, 'tick'>): boolean {
    if (this.cues.length >= MOST_CUES) return false;
    this.#insert(tidy({ ...shell, tick: this.cursor }), this.cues);
    this.cursor = Math.min(LAST_TICK, this.cursor + BEAT);
    return true;
  }

  remove(index: number): void {
    if (this.cues[index] === undefined) return;
    this.#change(this.cues.filter((_, i) => i !== index));
    this.chosen = -1;
  }

  /** Another time for a shell; it stays the chosen one. */
  move(index: number, tick: number): void {
    const cue = this.cues[index];
    if (cue === undefined) return;
    const moved = tidy({ ...cue, tick: Math.min(LAST_TICK, Math.max(0, tick)) });
    if (moved.tick === cue.tick) return;
    this.#insert(
      moved,
      this.cues.filter((_, i) => i !== index),
    );
  }

  clear(): void {
    if (this.cues.length > 0) this.#change([]);
    this.cursor = 0;
    this.chosen = -1;
  }

  /** Takes back the last change. */
  undo(): void {
    const before = this.#past.pop();
    if (before === undefined) return;
    if (before.length < this.cues.length) this.cursor = Math.max(0, this.cursor - BEAT);
    this.cues = before;
    this.chosen = -1;
    this.version++;
  }

  seek(tick: number): void {
    this.cursor = Math.min(LAST_TICK, Math.max(0, Math.round(tick / 6) * 6));
    this.version++;
  }

  #insert(cue: Cue, others: readonly Cue[]): void {
    const place = others.findIndex(({ tick }) => tick > cue.tick);
    const at = place < 0 ? others.length : place;
    this.#change([...others.slice(0, at), cue, ...others.slice(at)]);
    this.chosen = at;
  }

  #change(cues: readonly Cue[]): void {
    this.#past.push(this.cues);
    if (this.#past.length > 100) this.#past.shift();
    this.cues = cues;
    this.version++;
  }
}
