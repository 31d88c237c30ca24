import { bodies } from '@principia/physics';
import type { Address } from './address.ts';
import { type Banner, createBanner } from './banner.ts';
import { type Actions, type Commands, gameCommands } from './commands.ts';
import { type ControlListener, listenToControls } from './controls.ts';
import { toggleFullScreen } from './full-screen.ts';
import type { GameDefinition, Simulation, Stage } from './game.ts';
import { createHelpDialog, type HelpDialog } from './help-dialog.ts';
import { listenToKeys } from './keyboard.ts';
import { createLayout, type Layout } from './layout.ts';
import { startLoop } from './loop.ts';
import { createOutcomeCard, type OutcomeCard } from './outcome-card.ts';
import { type Looks, Preferences } from './preferences.ts';
import { Recorder } from './recorder.ts';
import { Session } from './session.ts';
import type { Settings } from './settings.ts';
import type { Side } from './side.ts';
import { bodyState, type GameHook, sessionState } from './test-hook.ts';
import { createToolbar, type Toolbar } from './toolbar.ts';
import { ViewHost } from './view-host.ts';

/** Seconds between two looks at the figures and the plot. */
const FIGURES_INTERVAL = 0.2;
/** Least seconds between two new worlds while a slider is dragged. */
const RESET_INTERVAL = 0.12;
const SLOW_MOTION = 0.2;

/** A game on a page: the session, the view, and everything around them. */
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
  /** There from the second frame on. */
  #side: Side | undefined;
  readonly #preferences = new Preferences(matchMedia('(prefers-reduced-motion: reduce)').matches);
  #renderer: string;
  /** The player holds the way back. */
  #rewinding = false;
  /** A setting asked for a new world. */
  #resetWanted = false;
  #sinceReset = 0;
  #sinceFigures = 0;
  /** Something threw; the world rests until it is made anew. */
  #broken = false;
  /** The step shown last. */
  #tick = 0;
  readonly #timing = { frame: 0, step: 0, draw: 0 };
  readonly #figures = { ...this.#timing, bodies: 0, contacts: undefined as number | undefined, time: 0 };

  constructor(game: GameDefinition<S, Sim>, address: Address<S>) {
    this.#game = game;
    this.#renderer = address.renderer;
    this.#manual = address.manual;
    this.#session = new Session(game, address.values, address.seed);
    this.#session.paused = address.manual;
    this.#layout = createLayout(game.title, () => this.#views.view?.fit());
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
    this.#outcome = game.outcome && createOutcomeCard(root, game.title, () => this.#again(), watch);
    this.#views = new ViewHost(this.#stage(), `${game.title}, drawn live; press H for help`, {
      onTrouble: (sentence) => this.#banner.show(sentence, 'error', ['Try again', () => this.#show(this.#renderer)]),
      onRecovery: () => this.#banner.hide(),
    });
    this.#showLooks();
    if (address.problems.length > 0) this.#banner.show(address.problems.join('\n'), 'note');
  }

  async start(): Promise<void> {
    globalThis.addEventListener('error', (event) => this.#report(event.error ?? event.message));
    globalThis.addEventListener('unhandledrejection', (event) => this.#report(event.reason));
    listenToKeys(this.#commands.pressed, this.#commands.released);
    if (this.#preferences.calm && !this.#manual) {
      this.#session.paused = true;
      this.#banner.show('You want little motion, so the game waits: press Space or ▶ to start.', 'note');
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
    await this.#openSide();
  }

  async #openSide(): Promise<void> {
    const { createSide } = await import('./side.ts');
    const session = this.#session;
    this.#side = createSide(this.#layout.side, {
      settings: this.#game.settings,
      values: session.values,
      actions: this.#actions,
      set: (name, value) => this.#guard(() => this.#set(name, value)),
      world: () => (session.started ? session.sim.world : undefined),
      canReplay: this.#game.replay !== undefined,
    });
    this.#showLooks();
    this.#refresh();
  }

  #frame(seconds: number): void {
    const session = this.#session;
    if (!session.started) return;
    this.#sinceReset += seconds;
    this.#sinceFigures += seconds;
    if (this.#resetWanted && this.#sinceReset >= RESET_INTERVAL) this.#reset();
    this.#controls?.poll();
    if (this.#rewinding) this.#goBackBy(seconds * session.speed);
    else if (!this.#broken && !this.#manual) session.advance(seconds);
    this.#showOutcome();
    this.#side?.plot.note(session.sim.world);
    this.#draw(seconds);
    if (seconds > 0) this.#timing.frame += 0.1 * (seconds * 1000 - this.#timing.frame);
    if (session.sim.world.tick !== this.#tick) this.#timing.step += 0.1 * (session.stepTime - this.#timing.step);
    this.#tick = session.sim.world.tick;
    if (this.#sinceFigures >= FIGURES_INTERVAL) this.#showFigures();
  }

  #draw(seconds: number): void {
    const { view } = this.#views;
    if (view === undefined || this.#broken) return;
    const start = performance.now();
    view.draw(this.#session.alpha, seconds);
    this.#timing.draw += 0.1 * (performance.now() - start - this.#timing.draw);
    this.#recorder.take(view.canvas);
  }

  /** Who went back in time plays on, but not for the high scores. */
  #showOutcome(): void {
    const { sim, rewound } = this.#session;
    const outcome = this.#game.outcome?.(sim);
    if (outcome === undefined || !rewound) this.#outcome?.show(outcome);
    else
      this.#outcome?.show({
        ...outcome,
        score: 0,
        lines: [...outcome.lines, 'Not counted: part of it was played before.'],
      });
  }

  #goBackBy(seconds: number): void {
    this.#goBack(() => this.#session.rewind(seconds));
  }

  /** What was broken in the future may be whole in the past. */
  #goBack(move: () => boolean): void {
    if (!move()) return;
    this.#broken = false;
    this.#side?.panel.refresh();
    this.#views.view?.refresh('setting');
  }

  #showFigures(): void {
    this.#sinceFigures = 0;
    const { sim } = this.#session;
    const side = this.#side;
    if (side === undefined) return;
    side.plot.draw();
    const contacts = this.#game.contacts?.(sim);
    side.profile.show(sim.world);
    const figures = this.#figures;
    Object.assign(figures, this.#timing);
    figures.bodies = bodies(sim.world).count;
    figures.contacts = contacts;
    figures.time = sim.world.time;
    side.stats.show(figures);
  }

  /** Opens the picture of another renderer; the values stay, the world is made anew for its dimensions. */
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
    this.#renew(() => this.#session.reset(seed));
  }

  /** Makes another world, and shows it. */
  #renew(make: () => void): void {
    this.#resetWanted = false;
    this.#sinceReset = 0;
    make();
    this.#outcome?.show(undefined);
    this.#broken = false;
    this.#side?.plot.clear();
    this.#views.view?.refresh('world');
  }

  #set(name: string, value: unknown): void {
    if (this.#session.set(name, value)) this.#resetWanted = true;
    else this.#views.view?.refresh('setting');
  }

  #toggle(name: string): void {
    this.#guard(() => this.#set(name, !this.#session.values[name]));
    this.#side?.panel.refresh();
  }

  #pause(paused = !this.#session.paused): void {
    this.#session.paused = paused;
    this.#refresh();
  }

  #refresh(): void {
    const { paused, speed } = this.#session;
    const { calm, safeColors } = this.#preferences;
    this.#toolbar.show({ paused, slow: speed !== 1, rewinding: this.#rewinding, renderer: this.#renderer });
    this.#side?.tools.show({ filming: this.#recorder.filming, calm, safeColors });
    this.#side?.panel.refresh();
  }

  #change(looks: Partial<Looks>): void {
    this.#preferences.set(looks);
    this.#showLooks();
    if (looks.safeColors !== undefined && this.#session.started) this.#session.dress();
    this.#views.view?.refresh('world');
    this.#refresh();
  }

  #showLooks(): void {
    const { calm, safeColors } = this.#preferences;
    this.#layout.root.toggleAttribute('data-calm', calm);
    this.#layout.root.toggleAttribute('data-safe-colors', safeColors);
    this.#session.safeColors = safeColors;
    if (this.#side !== undefined) this.#side.plot.safeColors = safeColors;
  }

  /** Keys, touch pad and gamepad, for a game that is steered. */
  #listen(): ControlListener | undefined {
    const { controls } = this.#game;
    return controls && listenToControls(this.#layout.root, controls, () => this.#session.sim);
  }

  /** Another game after one has ended: with the next seed, so that it is not the same. */
  #again(): void {
    this.#guard(() => this.#reset((this.#session.seed + 1) % 2 ** 32));
    this.#views.view?.canvas.focus();
  }

  /** Does something at the player's wish; what goes wrong becomes a sentence. */
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
    this.#banner.show(`Something went wrong: ${message}`, 'error', [
      'Start again',
      () => this.#guard(() => this.#reset()),
    ]);
  }

  /** What cannot be done here is a note, not an accident. */
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
        this.#guard(() => this.#renew(() => session.replay()));
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
        this.#guard(() => this.#goBack(() => session.stepBack()));
      },
      fit: () => this.#views.view?.fit(),
      zoom: (factor) => this.#views.view?.zoom(factor),
      help: () => this.#help.toggle(),
      side: () => this.#layout.toggleSide(),
      plot: () => this.#side?.plot.next(),
      profile: () => this.#side?.profile.toggle(),
      picture: () => this.#attempt((canvas, time) => this.#recorder.picture(canvas, time)),
      film: () => this.#attempt((canvas, time) => this.#recorder.toggleFilm(canvas, time)),
      fullScreen: () => this.#attempt(() => toggleFullScreen(this.#layout.root)),
      calm: () => this.#change({ calm: !preferences.calm }),
      safeColors: () => this.#change({ safeColors: !preferences.safeColors }),
      renderer: (name) => void this.#show(name),
      toggle: (name) => this.#toggle(name),
    };
  }

  #stage(): Stage<S, Sim> {
    const session = this.#session;
    const preferences = this.#preferences;
    return {
      element: this.#layout.stage,
      insets: () => this.#layout.insets(),
      sim: () => session.sim,
      values: () => session.values,
      toggle: (name) => this.#toggle(name),
      alpha: () => session.alpha,
      holding: () => session.holding,
      get reducedMotion() {
        return preferences.calm;
      },
      get safeColors() {
        return preferences.safeColors;
      },
      say: (sentence) => this.#banner.show(sentence, 'note'),
    };
  }

  #createHook(): GameHook {
    const session = this.#session;
    return {
      renderers: Object.keys(this.#game.renderers),
      state: () => ({
        ...sessionState(session),
        calm: this.#preferences.calm,
        filming: this.#recorder.filming,
        ready: this.#views.view !== undefined && this.#side !== undefined,
        renderer: this.#renderer,
        banner: this.#banner.text,
        timing: { ...this.#timing },
        game: this.#game.tell?.(session.sim) ?? {},
      }),
      body: (index) => bodyState(session, this.#views.view, index),
      step: (count) => session.step(count),
      rewind: (seconds) => this.#goBack(() => session.rewind(seconds)),
      reset: (seed) => this.#reset(seed),
      set: (name, value) => {
        this.#set(name, value);
        if (this.#resetWanted) this.#reset();
        this.#side?.panel.refresh();
      },
      pause: () => this.#pause(true),
      resume: () => this.#pause(false),
      show: (renderer) => this.#show(renderer),
    };
  }
}
