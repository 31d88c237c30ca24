import { DrawingRate } from './drawing-rate.ts';
import type { Renderer, Simulation, View, ViewContext } from './game.ts';
import type { Settings } from './settings.ts';
import { words } from './words.ts';

/** Events of a view, with messages for the player. */
export interface ViewHostEvents {
  /**
   * The view was closed, and one of another renderer is to be opened: makes a world for it.
   * @returns whether it could be made
   */
  onSwitch(dimensions: 2 | 3): boolean;
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
  /** There is no view, because there was no world for it. */
  lacksWorld = false;
  /** Which frames the view draws. */
  readonly rate = new DrawingRate();
  /** The renderer of the view. */
  renderer: string;
  /** The renderer that the player chose last; its code may not have been loaded. */
  wanted: string;
  readonly #renderers: Readonly<Record<string, Renderer<S, Sim>>>;
  readonly #context: ViewContext<S, Sim>;
  readonly #events: ViewHostEvents;
  readonly #label: string;
  #ticket = 0;
  /** Settles when the view that was asked for last is open or has failed. */
  #opening: Promise<unknown> = Promise.resolve();

  /** @param first the renderer to begin with @param label accessible name of the canvas */
  constructor(
    renderers: Readonly<Record<string, Renderer<S, Sim>>>,
    first: string,
    context: ViewContext<S, Sim>,
    label: string,
    events: ViewHostEvents,
  ) {
    this.#renderers = renderers;
    this.renderer = first;
    this.wanted = first;
    this.#context = context;
    this.#label = label;
    this.#events = events;
  }

  /**
   * Opens a view of a renderer, with a new world of the same settings. If its code cannot be loaded, or its world cannot be made,
   * the one before comes back.
   * Resolves when a view is open or has failed.
   */
  async show(name: string): Promise<void> {
    const renderer = this.#renderers[name];
    if (renderer === undefined) throw new Error(`There is no renderer “${name}”.`);
    const before = this.view === undefined ? undefined : this.renderer;
    this.wanted = name;
    this.renderer = name;
    this.#close();
    this.#ticket++;
    this.lacksWorld = !this.#events.onSwitch(renderer.dimensions);
    const opening = this.lacksWorld ? Promise.resolve(false) : this.#open(renderer);
    this.#opening = opening;
    const isThere = await opening;
    if (isThere || before === undefined || before === name || this.renderer !== name) return;
    await this.show(before);
    this.wanted = name;
  }

  /** Closes the view for good. Resolves when one that was being opened has been destroyed. */
  async destroy(): Promise<void> {
    this.#ticket++;
    this.#close();
    await this.#opening;
  }

  /** @returns false where its code could not be loaded */
  async #open(renderer: Renderer<S, Sim>): Promise<boolean> {
    const ticket = ++this.#ticket;
    try {
      const view = await renderer.open(this.#context);
      // Another view was requested meanwhile.
      if (ticket !== this.#ticket) view.destroy();
      else this.#show(view);
    } catch (error) {
      if (ticket === this.#ticket) this.#events.onError(openingSentence(renderer.label, error));
      return !isLoadingError(error);
    }
    return true;
  }

  /** Tells the view that the world was replaced, or a setting changed. */
  refresh(what: 'world' | 'setting'): void {
    this.rate.wake();
    this.view?.refresh(what);
  }

  #close(): void {
    const { view } = this;
    this.view = undefined;
    this.isLost = false;
    view?.destroy();
    this.#context.element.replaceChildren();
  }

  #show(view: View): void {
    this.view = view;
    this.rate.wake();
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
