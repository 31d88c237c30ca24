import { bodies } from '@principia/physics';
import type { Address } from './address.ts';
import { type Banner, createBanner } from './banner.ts';
import { type Actions, type Commands, gameCommands } from './commands.ts';
import { type ControlListener, listenToControls } from './controls.ts';
import { toggleFullScreen } from './full-screen.ts';
import type { GameCard, GameDefinition, Simulation, ViewContext } from './game.ts';
import { createHelpDialog, type HelpDialog } from './help-dialog.ts';
import { listenToKeys } from './keyboard.ts';
import { createLayout, type Layout } from './layout.ts';
import { startLoop } from './loop.ts';
import { createOutcomeCard, type OutcomeCard } from './outcome-card.ts';
import { type AppearanceOptions, Preferences } from './preferences.ts';
import { Recorder } from './recorder.ts';
import { Session } from './session.ts';
import type { Settings } from './settings.ts';
import type { Sidebar } from './sidebar.ts';
import { bodyState, type GameHook, sessionState } from './test-hook.ts';
import { createToolbar, type Toolbar } from './toolbar.ts';
import { ViewHost } from './view-host.ts';

/** Interval of updates of statistics and plot, s. */
const STATS_INTERVAL = 0.2;
/** Shortest time between two new worlds while a slider is dragged, s. */
const RESET_INTERVAL = 0.12;
const SLOW_MOTION = 0.2;

/** A game on a page: the session, the view and the user interface around them. */
export class GameApp<S extends Settings, Sim extends Simulation> {
  readonly #game: GameDefinition<S, Sim>;
  readonly #session: Session<S, Sim>;
  readonly #manual: boolean;
  readonly #layout: Layout;
  readonly #banner: Banner;
  readonly #views: ViewHost<S, Sim>;
  readonly #toolbar: Toolbar;
  readonly #recorder: Recorder;
  readonly #help: HelpDialog;
  readonly #controls: ControlListener | undefined;
  readonly #outcome: OutcomeCard | undefined;
  readonly #actions: Actions;
  readonly #commands: Commands;
  /** Created after the first frame. */
  #sidebar: Sidebar | undefined;
  #cards: readonly GameCard<Sim>[] = [];
  readonly #preferences = new Preferences(matchMedia('(prefers-reduced-motion: reduce)').matches);
  #renderer: string;
  /** The player holds the rewind button. */
  #rewinding = false;
  /** A changed setting requires a new world. */
  #resetWanted = false;
  #sinceReset = 0;
  #sinceStats = 0;
  /** An error was thrown; the world is frozen until it is recreated. */
  #broken = false;
  /** The step that was drawn last. */
  #tick = 0;
  readonly #timing = { frame: 0, step: 0, draw: 0 };
  readonly #stats = { ...this.#timing, bodies: 0, contacts: undefined as number | undefined, time: 0 };

  constructor(game: GameDefinition<S, Sim>, address: Address<S>) {
    this.#game = game;
    this.#renderer = address.renderer;
    this.#manual = address.manual;
    this.#session = new Session(game, address.values, address.seed);
    this.#session.paused = address.manual;
    this.#layout = createLayout(game.title, () => this.#views.view?.fit(), game.hasSheet);
    this.#banner = createBanner(this.#layout.root);
    const renderers = Object.entries(game.renderers).map(([name, { label }]) => [name, label] as const);
    this.#actions = this.#makeActions();
    this.#commands = gameCommands(game, this.#actions);
    this.#toolbar = createToolbar(this.#layout.bar, this.#actions, renderers);
    const { root } = this.#layout;
    this.#recorder = new Recorder(game.title, () => this.#refresh());
    this.#help = createHelpDialog(root, game.title, this.#commands.help);
    this.#controls = this.#listen();
    const watch = game.replay && this.#actions.replay;
    this.#outcome = game.outcome && createOutcomeCard(root, game.title, () => this.#playAgain(), watch);
    this.#views = new ViewHost(this.#viewContext(), `${game.title}, drawn live; press H for help`, {
      onError: (sentence) => this.#banner.show(sentence, 'error', ['Try again', () => this.#show(this.#renderer)]),
      onRecovery: () => this.#banner.hide(),
    });
    this.#applyAppearance();
    if (address.problems.length > 0) this.#banner.show(address.problems.join('\n'), 'note');
  }

  async start(): Promise<void> {
    globalThis.addEventListener('error', (event) => this.#report(event.error ?? event.message));
    globalThis.addEventListener('unhandledrejection', (event) => this.#report(event.reason));
    listenToKeys(this.#commands.pressed, this.#commands.released);
    if (this.#preferences.reducedMotion && !this.#manual) {
      this.#session.paused = true;
      this.#banner.show('Paused because reduced motion is on. Press Space or ▶ to start.', 'note');
    }
    await this.#show(this.#renderer);
    if (this.#session.started) globalThis.__game = this.#createHook();
    startLoop(
      (seconds) => this.#frame(seconds),
      (error) => {
        this.#broken = true;
        this.#report(error);
      },
    );
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    await this.#openSidebar();
  }

  async #openSidebar(): Promise<void> {
    const { createSidebar } = await import('./sidebar.ts');
    const session = this.#session;
    this.#sidebar = createSidebar(this.#layout.sidebar, {
      settings: this.#game.settings,
      values: session.values,
      actions: this.#actions,
      set: (name, value) => this.#guard(() => this.#set(name, value)),
      world: () => (session.started ? session.sim.world : undefined),
      canReplay: this.#game.replay !== undefined,
      cards: (parent) => {
        this.#cards = this.#game.cards?.(parent) ?? [];
      },
    });
    this.#applyAppearance();
    this.#refresh();
  }

  #frame(seconds: number): void {
    const session = this.#session;
    if (!session.started) return;
    this.#sinceReset += seconds;
    this.#sinceStats += seconds;
    if (this.#resetWanted && this.#sinceReset >= RESET_INTERVAL) this.#reset();
    this.#controls?.poll();
    if (this.#rewinding) this.#rewindBy(seconds * session.speed);
    else if (!this.#broken && !this.#manual) session.advance(seconds);
    this.#showOutcome();
    this.#sidebar?.plot.record(session.sim.world);
    for (let i = 0; i < this.#cards.length; i++) this.#cards[i].record?.(session.sim);
    this.#draw(seconds);
    if (seconds > 0) this.#timing.frame += 0.1 * (seconds * 1000 - this.#timing.frame);
    if (session.sim.world.tick !== this.#tick) this.#timing.step += 0.1 * (session.stepTime - this.#timing.step);
    this.#tick = session.sim.world.tick;
    if (this.#sinceStats >= STATS_INTERVAL) this.#showStats();
  }

  #draw(seconds: number): void {
    const { view } = this.#views;
    if (view === undefined || this.#broken) return;
    const start = performance.now();
    view.draw(this.#session.alpha, seconds);
    this.#timing.draw += 0.1 * (performance.now() - start - this.#timing.draw);
    this.#recorder.captureFrame(view.canvas);
  }

  /** A player who rewound may play on, but the score is not ranked. */
  #showOutcome(): void {
    const { sim, rewound } = this.#session;
    const outcome = this.#game.outcome?.(sim);
    if (outcome === undefined || !rewound) this.#outcome?.show(outcome);
    else
      this.#outcome?.show({
        ...outcome,
        score: 0,
        lines: [...outcome.lines, 'Not ranked: you rewound.'],
      });
  }

  #rewindBy(seconds: number): void {
    this.#restorePast(() => this.#session.rewind(seconds));
  }

  /** A restored snapshot lies before the error. */
  #restorePast(move: () => boolean): void {
    if (!move()) return;
    this.#broken = false;
    this.#sidebar?.panel.refresh();
    this.#views.view?.refresh('setting');
  }

  #showStats(): void {
    this.#sinceStats = 0;
    const { sim } = this.#session;
    const sidebar = this.#sidebar;
    if (sidebar === undefined) return;
    sidebar.plot.draw();
    for (const card of this.#cards) card.show(sim);
    const contacts = this.#game.contacts?.(sim);
    sidebar.profile.show(sim.world);
    const stats = this.#stats;
    Object.assign(stats, this.#timing);
    stats.bodies = bodies(sim.world).count;
    stats.contacts = contacts;
    stats.time = sim.world.time;
    sidebar.stats.show(stats);
  }

  /** Opens the view of another renderer. Settings are kept; the world is recreated with the renderer's dimensions. */
  async #show(name: string): Promise<void> {
    const renderer = this.#game.renderers[name];
    if (renderer === undefined) throw new Error(`There is no renderer “${name}”.`);
    this.#renderer = name;
    this.#views.close();
    this.#session.dimensions = renderer.dimensions;
    this.#refresh();
    this.#guard(() => this.#reset());
    if (this.#session.started) await this.#views.open(renderer);
  }

  #reset(seed?: number): void {
    this.#replaceWorld(() => this.#session.reset(seed));
  }

  /** Replaces the world and shows the new one. */
  #replaceWorld(make: () => void): void {
    this.#resetWanted = false;
    this.#sinceReset = 0;
    make();
    this.#outcome?.show(undefined);
    this.#broken = false;
    this.#sidebar?.plot.clear();
    this.#views.view?.refresh('world');
  }

  #set(name: string, value: unknown): void {
    if (this.#session.set(name, value)) this.#resetWanted = true;
    else this.#views.view?.refresh('setting');
  }

  #toggle(name: string): void {
    this.#guard(() => this.#set(name, !this.#session.values[name]));
    this.#sidebar?.panel.refresh();
  }

  #pause(paused = !this.#session.paused): void {
    this.#session.paused = paused;
    this.#refresh();
  }

  #refresh(): void {
    const { paused, speed } = this.#session;
    const { reducedMotion, safeColors } = this.#preferences;
    this.#toolbar.show({ paused, slow: speed !== 1, rewinding: this.#rewinding, renderer: this.#renderer });
    this.#sidebar?.tools.show({ recording: this.#recorder.isRecording, reducedMotion, safeColors });
    this.#sidebar?.panel.refresh();
  }

  #change(changes: Partial<AppearanceOptions>): void {
    this.#preferences.set(changes);
    this.#applyAppearance();
    if (changes.safeColors !== undefined && this.#session.started) this.#session.applyColors();
    this.#views.view?.refresh('world');
    this.#refresh();
  }

  #applyAppearance(): void {
    const { reducedMotion, safeColors } = this.#preferences;
    this.#layout.root.toggleAttribute('data-reduced-motion', reducedMotion);
    this.#layout.root.toggleAttribute('data-safe-colors', safeColors);
    this.#session.safeColors = safeColors;
    if (this.#sidebar !== undefined) this.#sidebar.plot.safeColors = safeColors;
  }

  /** Listens to keys, touch pad and gamepad if the game has controls. */
  #listen(): ControlListener | undefined {
    const { controls } = this.#game;
    return controls && listenToControls(this.#layout.root, controls, () => this.#session.sim);
  }

  /** Starts another game after the end of one, with the next seed so that it differs. */
  #playAgain(): void {
    this.#guard(() => this.#reset((this.#session.seed + 1) % 2 ** 32));
    this.#views.view?.canvas.focus();
  }

  /** Runs an action of the player and reports errors on the banner. */
  #guard(action: () => void): void {
    try {
      action();
    } catch (error) {
      this.#report(error);
    }
  }

  #report(error: unknown): void {
    const message = error instanceof Error ? error.message : String(error);
    console.error(error);
    this.#banner.show(`Something went wrong: ${message}`, 'error', ['Restart', () => this.#guard(() => this.#reset())]);
  }

  /** Runs an action that the browser may refuse; a refusal is shown as a note, not as an error. */
  #attempt(action: (canvas: HTMLCanvasElement, time: number) => unknown): void {
    const { view } = this.#views;
    if (view === undefined) return;
    const note = (error: unknown) => this.#banner.show((error as Error).message, 'note');
    this.#draw(0);
    try {
      Promise.resolve(action(view.canvas, this.#session.sim.world.time)).catch(note);
    } catch (error) {
      note(error);
    }
  }

  #makeActions(): Actions {
    const session = this.#session;
    const preferences = this.#preferences;
    return {
      pause: () => this.#pause(),
      step: () => {
        this.#pause(true);
        this.#guard(() => session.step());
      },
      reset: () => this.#guard(() => this.#reset()),
      replay: () => {
        this.#guard(() => this.#replaceWorld(() => session.replay()));
        if (!this.#manual) this.#pause(false);
        this.#views.view?.canvas.focus();
      },
      slow: () => {
        session.speed = session.speed === 1 ? SLOW_MOTION : 1;
        this.#refresh();
      },
      rewind: (on) => {
        this.#rewinding = on;
        this.#refresh();
      },
      stepBack: () => {
        this.#pause(true);
        this.#guard(() => this.#restorePast(() => session.stepBack()));
      },
      fit: () => this.#views.view?.fit(),
      zoom: (factor) => this.#views.view?.zoom(factor),
      help: () => this.#help.toggle(),
      sidebar: () => this.#layout.toggleSidebar(),
      plot: () => this.#sidebar?.plot.next(),
      profile: () => this.#sidebar?.profile.toggle(),
      screenshot: () => this.#attempt((canvas, time) => this.#recorder.saveScreenshot(canvas, time)),
      recordVideo: () => this.#attempt((canvas, time) => this.#recorder.toggleVideo(canvas, time)),
      fullScreen: () => this.#attempt(() => toggleFullScreen(this.#layout.root)),
      reducedMotion: () => this.#change({ reducedMotion: !preferences.reducedMotion }),
      safeColors: () => this.#change({ safeColors: !preferences.safeColors }),
      renderer: (name) => void this.#show(name),
      toggle: (name) => this.#toggle(name),
    };
  }

  #viewContext(): ViewContext<S, Sim> {
    const session = this.#session;
    const preferences = this.#preferences;
    return {
      element: this.#layout.stage,
      insets: () => this.#layout.insets(),
      sim: () => session.sim,
      values: () => session.values,
      toggle: (name) => this.#toggle(name),
      alpha: () => session.alpha,
      dragging: () => session.dragging,
      get reducedMotion() {
        return preferences.reducedMotion;
      },
      get safeColors() {
        return preferences.safeColors;
      },
      showMessage: (sentence) => this.#banner.show(sentence, 'note'),
    };
  }

  #createHook(): GameHook {
    const session = this.#session;
    return {
      renderers: Object.keys(this.#game.renderers),
      state: () => ({
        ...sessionState(session),
        reducedMotion: this.#preferences.reducedMotion,
        recording: this.#recorder.isRecording,
        ready: this.#views.view !== undefined && this.#sidebar !== undefined,
        renderer: this.#renderer,
        banner: this.#banner.text,
        timing: { ...this.#timing },
        game: this.#game.report?.(session.sim) ?? {},
      }),
      body: (index) => bodyState(session, this.#views.view, index),
      step: (count) => session.step(count),
      rewind: (seconds) => this.#restorePast(() => session.rewind(seconds)),
      reset: (seed) => this.#reset(seed),
      set: (name, value) => {
        this.#set(name, value);
        if (this.#resetWanted) this.#reset();
        this.#sidebar?.panel.refresh();
      },
      pause: () => this.#pause(true),
      resume: () => this.#pause(false),
      show: (renderer) => this.#show(renderer),
    };
  }
}
