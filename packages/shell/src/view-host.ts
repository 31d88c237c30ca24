import type { Renderer, Simulation, View, ViewContext } from './game.ts';
import type { Settings } from './settings.ts';
import { words } from './words.ts';

/** Events of a view, with messages for the player. */
export interface ViewHostEvents {
  /** Drawing failed; `sentence` says why. */
  onError(sentence: string): void;
  /** The graphics context was restored. */
  onRecovery(): void;
}

/** Owns the view on display and switches between renderers. */
export class ViewHost<S extends Settings, Sim extends Simulation> {
  view: View | undefined;
  /** The graphics context of the view is lost. */
  isLost = false;
  readonly #context: ViewContext<S, Sim>;
  readonly #events: ViewHostEvents;
  readonly #label: string;
  #wanted = 0;

  /** @param label accessible name of the canvas */
  constructor(context: ViewContext<S, Sim>, label: string, events: ViewHostEvents) {
    this.#context = context;
    this.#label = label;
    this.#events = events;
  }

  /**
   * Closes the present view and opens one of `renderer`. Resolves when the view is open or has failed.
   * @returns false where its code could not be loaded
   */
  async open(renderer: Renderer<S, Sim>): Promise<boolean> {
    const ticket = ++this.#wanted;
    this.close();
    try {
      const view = await renderer.open(this.#context);
      // Another view was requested meanwhile.
      if (ticket !== this.#wanted) view.destroy();
      else this.#show(view);
    } catch (error) {
      if (ticket === this.#wanted) this.#events.onError(openingSentence(renderer.label, error));
      return !isLoadingError(error);
    }
    return true;
  }

  close(): void {
    const { view } = this;
    this.view = undefined;
    this.isLost = false;
    view?.destroy();
    this.#context.element.replaceChildren();
  }

  #show(view: View): void {
    this.view = view;
    const { canvas } = view;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', this.#label);
    canvas.addEventListener('webglcontextlost', () => {
      if (this.view === view) {
        this.isLost = true;
        this.#events.onError(words().contextLost);
      }
    });
    canvas.addEventListener('webglcontextrestored', () => {
      if (this.view !== view) return;
      this.isLost = false;
      this.#events.onRecovery();
    });
  }
}

/** Chromium, Firefox and Safari report a module that they cannot fetch as a `TypeError` with a text of their own. */
export function isLoadingError(error: unknown): boolean {
  return error instanceof TypeError && /dynamically imported module|importing a module script/i.test(error.message);
}

function openingSentence(label: string, error: unknown): string {
  if (isLoadingError(error)) {
    return words().notLoaded(label);
  }
  const canDraw = document.createElement('canvas').getContext('webgl2') !== null;
  if (!canDraw) {
    return words().noWebGl;
  }
  return words().notOpened(label, error instanceof Error ? error.message : String(error));
}
