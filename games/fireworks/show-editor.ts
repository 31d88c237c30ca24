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
    this.cursor = endOf(cues);
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

  /** Puts another show in the place of this one. @param cues sorted by time */
  load(cues: readonly Cue[]): void {
    this.#change(cues.map(quantize));
    this.cursor = endOf(cues);
    this.chosen = -1;
  }

  clear(): void {
    if (this.cues.length > 0) this.#change([]);
    this.cursor = 0;
    this.chosen = -1;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  /** Undoes the last change. */
  undo(): void {
    const before = this.#past.pop();
    if (before === undefined) return;
    const added = this.cues.length - before.length;
    if (added === 1) this.cursor = Math.max(0, this.cursor - BEAT);
    // More than one shell came or went with another show.
    else if (Math.abs(added) > 1) this.cursor = endOf(before);
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

/** A beat after the last shell. */
function endOf(cues: readonly Cue[]): number {
  const last = cues.at(-1);
  return last === undefined ? 0 : Math.min(LAST_TICK, last.tick + BEAT);
}
