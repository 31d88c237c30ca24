/** What the reader wants to see; left out, everything. */
export interface Shown {
  readonly arrows?: unknown;
  readonly trails?: unknown;
}
