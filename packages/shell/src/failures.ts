import type { Banner } from './banner.ts';
import { words } from './words.ts';

/** Turns what goes wrong into sentences on the banner. */
export class Failures {
  readonly #banner: Banner;
  readonly #restart: () => void;

  /** @param restart creates the world anew, on the player's request after an error */
  constructor(banner: Banner, restart: () => void) {
    this.#banner = banner;
    this.#restart = restart;
  }

  /** Reports the errors of the whole page until the signal. */
  listen(signal: AbortSignal): void {
    globalThis.addEventListener('error', (event) => this.report(event.error ?? event.message), { signal });
    globalThis.addEventListener('unhandledrejection', (event) => this.report(event.reason), { signal });
  }

  /** Runs an action and reports its errors. */
  guard(action: () => void): void {
    try {
      action();
    } catch (error) {
      this.report(error);
    }
  }

  report(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    console.error(error);
    this.#banner.show(words().wrong(message), 'error', [words().restart, () => this.guard(this.#restart)]);
  }

  /** Runs an action that the browser may refuse; a refusal is shown as a note, not as an error. */
  attempt(action: () => unknown): void {
    const note = (error: unknown) => this.#banner.show((error as Error).message, 'note');
    try {
      Promise.resolve(action()).catch(note);
    } catch (error) {
      note(error);
    }
  }
}
