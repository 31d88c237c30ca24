import { bodies } from '@principia/physics';
import type { Address } from './address.ts';
import { type Banner, createBanner } from './banner.ts';
import { type ControlListener, listenToControls } from './controls.ts';
import { createEnergyPlot, type EnergyPlot } from './energy-plot.ts';
import type { GameDefinition, Simulation, Stage } from './game.ts';
import { createHelpDialog, type HelpDialog } from './help-dialog.ts';
import { helpLines } from './help-lines.ts';
import { type Keys, listenToKeys } from './keyboard.ts';
import { createLayout, type Layout } from './layout.ts';
import { startLoop } from './loop.ts';
import { createOutcomeCard, type OutcomeCard } from './outcome-card.ts';
import { createPanel, type Panel } from './panel.ts';
import { Session } from './session.ts';
import type { Settings } from './settings.ts';
import { createStats, type Stats } from './stats.ts';
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
  readonly #panel: Panel;
  readonly #plot: EnergyPlot;
  readonly #stats: Stats;
  readonly #help: HelpDialog;
  readonly #controls: ControlListener | undefined;
  readonly #outcome: OutcomeCard | undefined;
  readonly #reducedMotion = matchMedia('(prefers-reduced-motion: reduce)').matches;
  #renderer: string;
  /** A setting asked for a new world. */
  #resetWanted = false;
  #sinceReset = 0;
  #sinceFigures = 0;
  /** Something threw; the world rests until it is made anew. */
  #broken = false;
  /** The step shown last. */
  #tick = 0;
  readonly #timing = { frame: 0, step: 0, draw: 0 };

  constructor(game: GameDefinition<S, Sim>, address: Address<S>) {
    this.#game = game;
    this.#renderer = address.renderer;
    this.#manual = address.manual;
    this.#session = new Session(game, address.values, address.seed);
    this.#session.paused = address.manual;
    this.#layout = createLayout(game.title, () => this.#views.view?.fit());
    this.#banner = createBanner(this.#layout.root);
    const renderers = Object.entries(game.renderers).map(([name, { label }]) => [name, label] as const);
    this.#toolbar = createToolbar(this.#layout.bar, this.#actions(), renderers);
    this.#panel = createPanel(this.#layout.side, game.settings, address.values, (name, value) => {
      this.#guard(() => this.#set(name, value));
    });
    this.#plot = createEnergyPlot(this.#layout.side);
    this.#stats = createStats(this.#layout.side);
    this.#help = createHelpDialog(this.#layout.root, game.title, helpLines(game));
    this.#controls = this.#listen();
    this.#outcome = game.outcome && createOutcomeCard(this.#layout.root, game.title, () => this.#again());
    this.#views = new ViewHost(this.#stage(), `${game.title}, drawn live; press H for help`, {
      onTrouble: (sentence) => this.#banner.show(sentence, 'error', ['Try again', () => this.#show(this.#renderer)]),
      onRecovery: () => this.#banner.hide(),
    });
    if (address.problems.length > 0) this.#banner.show(address.problems.join('\n'), 'note');
  }

  async start(): Promise<void> {
    globalThis.addEventListener('error', (event) => this.#report(event.error ?? event.message));
    globalThis.addEventListener('unhandledrejection', (event) => this.#report(event.reason));
    listenToKeys(this.#keys());
    if (this.#reducedMotion && !this.#manual) {
      this.#session.paused = true;
      this.#banner.show('Your system asks for little motion, so the game waits: press Space or ▶ to start.', 'note');
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
  }

  #frame(seconds: number): void {
    const session = this.#session;
    if (!session.started) return;
    this.#sinceReset += seconds;
    this.#sinceFigures += seconds;
    if (this.#resetWanted && this.#sinceReset >= RESET_INTERVAL) this.#reset();
    this.#controls?.poll();
    if (!this.#broken && !this.#manual) session.advance(seconds);
    this.#outcome?.show(this.#game.outcome?.(session.sim));
    this.#plot.note(session.sim.world);
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
  }

  #showFigures(): void {
    this.#sinceFigures = 0;
    const { sim } = this.#session;
    this.#plot.draw();
    const contacts = this.#game.contacts?.(sim);
    this.#stats.show({ ...this.#timing, bodies: bodies(sim.world).count, contacts, time: sim.world.time });
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
    this.#resetWanted = false;
    this.#sinceReset = 0;
    this.#session.reset(seed);
    this.#broken = false;
    this.#plot.clear();
    this.#views.view?.refresh('world');
  }

  #set(name: string, value: unknown): void {
    if (this.#session.set(name, value)) this.#resetWanted = true;
    else this.#views.view?.refresh('setting');
  }

  #pause(paused = !this.#session.paused): void {
    this.#session.paused = paused;
    this.#refresh();
  }

  #refresh(): void {
    this.#toolbar.show({ paused: this.#session.paused, renderer: this.#renderer });
    this.#panel.refresh();
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

  #actions() {
    return {
      pause: () => this.#pause(),
      step: () => {
        this.#pause(true);
        this.#guard(() => this.#session.step());
      },
      reset: () => this.#guard(() => this.#reset()),
      fit: () => this.#views.view?.fit(),
      help: () => this.#help.toggle(),
      side: () => this.#layout.toggleSide(),
      renderer: (name: string) => void this.#show(name),
    };
  }

  #keys(): Keys {
    const { pause, step, reset, fit, help, side } = this.#actions();
    const zoom = (factor: number) => () => this.#views.view?.zoom(factor);
    const keys: Record<string, () => void> = {
      ...{ ' ': pause, '.': step, arrowright: step, r: reset, f: fit, h: help, '?': help, p: side },
      ...{ '+': zoom(1.25), '=': zoom(1.25), '-': zoom(0.8), e: () => this.#plot.toggle() },
      s: () => {
        this.#session.speed = this.#session.speed === 1 ? SLOW_MOTION : 1;
      },
    };
    for (const [name, { dimensions }] of Object.entries(this.#game.renderers)) {
      keys[String(dimensions)] = () => void this.#show(name);
    }
    for (const { keys: own } of Object.values(this.#game.controls?.buttons ?? {})) {
      for (const key of own) delete keys[key];
    }
    for (const [name, setting] of Object.entries(this.#game.settings)) {
      if (setting.kind !== 'switch' || setting.key === undefined) continue;
      keys[setting.key] = () =>
        this.#guard(() => {
          this.#set(name, !this.#session.values[name]);
          this.#panel.refresh();
        });
    }
    return keys;
  }

  #stage(): Stage<S, Sim> {
    const session = this.#session;
    return {
      element: this.#layout.stage,
      insets: () => this.#layout.insets(),
      sim: () => session.sim,
      values: () => session.values,
      alpha: () => session.alpha,
      holding: () => session.holding,
      reducedMotion: this.#reducedMotion,
    };
  }

  #createHook(): GameHook {
    const session = this.#session;
    return {
      state: () => ({
        ...sessionState(session),
        ...{ ready: this.#views.view !== undefined, renderer: this.#renderer, banner: this.#banner.text },
        timing: { ...this.#timing },
        game: this.#game.tell?.(session.sim) ?? {},
      }),
      body: (index) => bodyState(session, this.#views.view, index),
      step: (count) => session.step(count),
      reset: (seed) => this.#reset(seed),
      set: (name, value) => {
        this.#set(name, value);
        if (this.#resetWanted) this.#reset();
        this.#panel.refresh();
      },
      pause: () => this.#pause(true),
      resume: () => this.#pause(false),
      show: (renderer) => this.#show(renderer),
    };
  }
}
