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

  /** Runs an action and reports its errors. @returns whether there was none */
  guard(action: () => void): boolean {
    try {
      action();
      return true;
    } catch (error) {
      this.report(error);
      return false;
    }
  }

  report(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    console.error(error);
    this.#banner.show(words().wrong(message), 'error', [words().restart, () => this.guard(this.#restart)]);
  }

  /** Takes the sentence of an error from the banner, because something else is tried. */
  forget(): void {
    if (this.#banner.kind === 'error') this.#banner.hide();
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
