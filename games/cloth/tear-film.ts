/** Shows a tear again, four times slower: a button appears after a tear, and any press ends the film. */
import { element } from '@principia/shell';
import type { ClothRun } from './sim.ts';
import type { Tear } from './tear-record.ts';
import { WORDS } from './words.ts';

/** Simulated seconds of a second of film. */
const SPEED = 0.25;
/** How long the button is offered, s. */
const OFFER_SECONDS = 7;

export class TearFilm {
  /** The time on display, in steps; undefined while no film runs. */
  time: number | undefined;
  /** Positions of all nodes at that time: x, y and z of each, m. */
  readonly positions: Float32Array;
  /** Number of threads that hold at that time. */
  threads = 0;
  readonly #sim: ClothRun;
  readonly #button: HTMLButtonElement;
  readonly #label: HTMLElement;
  readonly #stop = new AbortController();
  #tear: Tear | undefined;
  #offered = 0;

  constructor(sim: ClothRun, parent: HTMLElement) {
    this.#sim = sim;
    this.positions = new Float32Array(3 * sim.tears.nodeCount);
    this.#button = element('button', 'cloth-button cloth-again', { type: 'button' }, WORDS.film);
    this.#label = element('p', 'cloth-film', { role: 'status' });
    this.#button.hidden = true;
    parent.append(this.#button, this.#label);
    this.#button.addEventListener('click', () => this.#begin());
    const { signal } = this.#stop;
    for (const type of ['pointerdown', 'keydown'])
      parent.ownerDocument.addEventListener(type, () => this.#end(), { capture: true, signal });
  }

  /** Call it once a frame. @returns the number of threads that ended in the film since the last call */
  update(seconds: number): number {
    if (this.time === undefined) {
      this.#offer(seconds);
      return 0;
    }
    this.time += (SPEED * seconds) / this.#sim.dt;
    const { tears } = this.#sim;
    if (this.time > (this.#tear as Tear).to || !tears.positionsAt(this.time, this.positions)) {
      this.#end();
      return 0;
    }
    const before = this.threads;
    this.threads = tears.threadsAt(this.time);
    return before - this.threads;
  }

  destroy(): void {
    this.#end();
    this.#stop.abort();
    this.#button.remove();
    this.#label.remove();
  }

  /** A tear is offered for some seconds, and once only. */
  #offer(seconds: number): void {
    const { tear } = this.#sim.tears;
    if (tear?.to !== this.#tear?.to) this.#offered = 0;
    this.#tear = tear;
    this.#offered += seconds;
    this.#button.hidden = tear === undefined || this.#offered > OFFER_SECONDS;
  }

  #begin(): void {
    const { tears } = this.#sim;
    const { tear } = tears;
    if (tear === undefined) return;
    this.#tear = tear;
    tears.isFrozen = true;
    this.time = tear.from;
    tears.positionsAt(tear.from, this.positions);
    this.threads = tears.threadsAt(tear.from);
    this.#button.hidden = true;
    this.#label.textContent = WORDS.filmRuns;
  }

  #end(): void {
    if (this.time === undefined) return;
    this.time = undefined;
    this.#sim.tears.isFrozen = false;
    this.#label.textContent = '';
  }
}
