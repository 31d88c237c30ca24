/** The editor of a show: shells on a timeline. It does not depend on the page. */
import { LAST_TICK, MAX_CUES, quantize } from './show.ts';
import type { Cue } from './sim.ts';

/** Steps by which the cursor advances after a click. */
export const BEAT = 36;

export class ShowEditor {
  /** Sorted by time. */
  cues: readonly Cue[];
  /** Time of the next shell, steps. */
  cursor: number;
  /** Index of the selected shell in `cues`; -1 for none. */
  chosen = -1;
  /** Incremented by every change. */
  version = 0;
  readonly #past: (readonly Cue[])[] = [];

  constructor(cues: readonly Cue[] = []) {
    this.cues = cues;
    this.cursor = cues.length === 0 ? 0 : Math.min(LAST_TICK, cues[cues.length - 1].tick + BEAT);
  }

  /** Adds a shell at the cursor, which advances by a beat. @returns false when the show is full */
  add(shell: Omit<Cue, 'tick'>): boolean {
    if (this.cues.length >= MAX_CUES) return false;
    this.#insert(quantize({ ...shell, tick: this.cursor }), this.cues);
    this.cursor = Math.min(LAST_TICK, this.cursor + BEAT);
    return true;
  }

  remove(index: number): void {
    if (this.cues[index] === undefined) return;
    this.#change(this.cues.filter((_, i) => i !== index));
    this.chosen = -1;
  }

  /** Changes the time of a shell, which stays selected. */
  move(index: number, tick: number): void {
    const cue = this.cues[index];
    if (cue === undefined) return;
    const moved = quantize({ ...cue, tick: Math.min(LAST_TICK, Math.max(0, tick)) });
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

  /** Undoes the last change. */
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
