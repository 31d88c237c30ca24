import type { Renderer, Simulation, Stage, View } from './game.ts';
import type { Settings } from './settings.ts';

/** What happened to a view, in words for the player. */
export interface ViewHostEvents {
  /** The picture cannot be drawn; `sentence` says why. */
  onTrouble(sentence: string): void;
  /** The graphics card is back. */
  onRecovery(): void;
}

/** The one view that is shown, and the change from one to another. */
export class ViewHost<S extends Settings, Sim extends Simulation> {
  view: View | undefined;
  readonly #stage: Stage<S, Sim>;
  readonly #events: ViewHostEvents;
  readonly #label: string;
  #wanted = 0;

  /** @param label what the canvas is called to those who cannot see it */
  constructor(stage: Stage<S, Sim>, label: string, events: ViewHostEvents) {
    this.#stage = stage;
    this.#label = label;
    this.#events = events;
  }

  /** Takes the present view away and opens one of `renderer`. Resolves when it is there or has failed. */
  async open(renderer: Renderer<S, Sim>): Promise<void> {
    const ticket = ++this.#wanted;
    this.close();
    try {
      const view = await renderer.open(this.#stage);
      // Somebody asked for another one meanwhile.
      if (ticket !== this.#wanted) view.destroy();
      else this.#show(view);
    } catch (error) {
      if (ticket === this.#wanted) this.#events.onTrouble(openingSentence(renderer.label, error));
    }
  }

  close(): void {
    const { view } = this;
    this.view = undefined;
    view?.destroy();
    this.#stage.element.replaceChildren();
  }

  #show(view: View): void {
    this.view = view;
    const { canvas } = view;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', this.#label);
    canvas.addEventListener('webglcontextlost', () => {
      if (this.view === view) {
        this.#events.onTrouble('The graphics card was taken away; the picture comes back as soon as it does.');
      }
    });
    canvas.addEventListener('webglcontextrestored', () => {
      if (this.view === view) this.#events.onRecovery();
    });
  }
}

function openingSentence(label: string, error: unknown): string {
  const canDraw = document.createElement('canvas').getContext('webgl2') !== null;
  if (!canDraw) {
    return 'This browser offers no WebGL 2, so there is no picture. Switch hardware acceleration on, or try another browser.';
  }
  return `The ${label} picture could not be opened: ${error instanceof Error ? error.message : error}`;
}
