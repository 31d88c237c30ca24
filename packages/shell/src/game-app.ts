import { type Address, writeAddress } from './address.ts';
import { keepInAddress } from './address-bar.ts';
import { type Banner, createBanner } from './banner.ts';
import { hasCoarsePointer, resumeHint } from './coarse-pointer.ts';
import { type Actions, type Commands, gameCommands } from './commands.ts';
import { type ControlListener, listenToControls } from './controls.ts';
import { Failures } from './failures.ts';
import { tendFocus } from './focus.ts';
import { DRAW, FRAME, FrameTimes, STEP } from './frame-times.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { createActions } from './game-actions.ts';
import type { GamePlace } from './game-place.ts';
import { createHelpDialog, type HelpDialog } from './help-dialog.ts';
import { RESET_INTERVAL, STATS_INTERVAL } from './intervals.ts';
import { listenToKeys } from './keyboard.ts';
import { createLayout, type Layout } from './layout.ts';
import { startLoop } from './loop.ts';
import { createOutcomeCard, type OutcomeCard } from './outcome-card.ts';
import { listenToPage, systemReducesMotion } from './page-events.ts';
import { closePanelThatCovers, pauseWhileCovered } from './panel-cover.ts';
import { type AppearanceOptions, Preferences } from './preferences.ts';
import { isPreview, startPreview } from './preview.ts';
import { Session } from './session.ts';
import type { Settings } from './settings.ts';
import { Sharing } from './sharing.ts';
import type { Sidebar } from './sidebar.ts';
import { SpaceBar } from './space-bar.ts';
import { countInto, noStatistics } from './statistics.ts';
import { createHook, type GameHook, offerHook } from './test-hook.ts';
import { createTimeline, type Timeline } from './timeline.ts';
import { createToolbar, type Toolbar } from './toolbar.ts';
import { createViewContext } from './view-context.ts';
import { ViewHost } from './view-host.ts';
import { words } from './words.ts';

/** A game on a page: the session, the view and the user interface around them. */
export class GameApp<S extends Settings, Sim extends Simulation> {
  readonly #game: GameDefinition<S, Sim>;
  readonly session: Session<S, Sim>;
  readonly address: Address<S>;
  readonly layout: Layout;
  readonly #banner: Banner;
  readonly failures: Failures;
  readonly views: ViewHost<S, Sim>;
  readonly #toolbar: Toolbar;
  readonly sharing: Sharing;
  readonly help: HelpDialog;
  readonly space: SpaceBar;
  readonly #controls: ControlListener | undefined;
  readonly #outcome: OutcomeCard | undefined;
  readonly #timeline: Timeline | undefined;
  readonly #actions: Actions;
  readonly #commands: Commands;
  /** Created after the first frame. */
  sidebar: Sidebar<Sim> | undefined;
  readonly preferences = new Preferences(systemReducesMotion());
  /** The player holds the rewind button. */
  rewinding = false;
  /** A changed setting requires a new world. */
  #resetWanted = false;
  #sinceReset = 0;
  #sinceStats = 0;
  /** An error was thrown; the world is frozen until it is recreated. */
  #broken = false;
  /** The step that was drawn last. */
  #tick = 0;
  readonly #timing = new FrameTimes();
  readonly #stats = noStatistics();
  readonly #place: GamePlace;
  #onSetting = () => {};
  /** What hears the keys. */
  readonly #keyTarget: HTMLElement | Document;
  /** Ends the listeners of the game. */
  readonly #end = new AbortController();

  constructor(game: GameDefinition<S, Sim>, address: Address<S>, place: GamePlace) {
    const { parent } = place;
    const { signal } = this.#end;
    this.#game = game;
    this.#place = place;
    this.address = address;
    this.session = new Session(game, address.values, address.seed);
    this.session.paused = address.manual;
    this.session.afterStep = () => this.sidebar?.plot.record(this.session.sim.world);
    this.layout = createLayout({
      title: game.title,
      parent,
      isSheet: game.hasSheet,
      onSidebar: () => this.views.view?.fit(),
      onCover: pauseWhileCovered(this),
      signal,
    });
    this.#banner = createBanner(this.layout.root);
    this.failures = new Failures(this.#banner, () => this.reset());
    const renderers = Object.entries(game.renderers).map(([name, { label }]) => [name, label] as const);
    this.#actions = createActions(this);
    this.#commands = gameCommands(game, this.#actions);
    this.#toolbar = createToolbar(this.layout.bar, this.#actions, renderers, game.home);
    const { root } = this.layout;
    this.#keyTarget = parent === undefined ? document : root;
    tendFocus(root, parent !== undefined, signal);
    closePanelThatCovers(this.layout, this.#keyTarget, signal);
    this.space = new SpaceBar(this.layout.stage, () => this.pause());
    this.sharing = this.#makeSharing();
    this.help = createHelpDialog(root, game.title, this.#commands[hasCoarsePointer() ? 'gestures' : 'help']);
    this.#controls = game.controls && listenToControls(root, game.controls, () => this.session.sim, this.#keyTarget);
    const seek = (moment: number) => this.#seek(moment);
    this.#timeline = game.hasTimeline ? createTimeline(root, this.session, seek, () => this.pause()) : undefined;
    if (place.ownsAddress) this.#onSetting = keepInAddress(game.settings, this.session.values, signal);
    const watch = game.replay && this.#actions.replay;
    this.#outcome =
      game.outcome &&
      createOutcomeCard(
        root,
        game.scoresName ?? game.title,
        () => this.#playAgain(),
        watch,
        (text) => void this.sharing.share(text),
      );
    this.views = new ViewHost(
      game.renderers,
      address.renderer,
      createViewContext(this.layout, this.session, this.preferences, {
        isSpaceHeld: () => this.space.isHeld,
        toggle: (name) => this.toggle(name),
        showMessage: (sentence) => this.#banner.show(sentence, 'note'),
        clip: this.sharing,
      }),
      words().drawnLive(game.title),
      {
        onSwitch: (dimensions) => this.#prepareWorld(dimensions),
        onError: (sentence) => {
          this.sharing.dropClip();
          this.#banner.show(sentence, 'error', [words().tryAgain, () => this.views.show(this.views.wanted)]);
        },
        onRecovery: () => this.#banner.hide(),
      },
    );
    this.#applyAppearance();
    if (address.problems.length > 0) this.#banner.show(address.problems.join('\n'), 'note');
  }

  async start(): Promise<void> {
    const { signal } = this.#end;
    // The errors of a page around the game are not the game's.
    if (this.#place.parent === undefined) this.failures.listen(signal);
    const stopKeys = listenToKeys(this.#commands.pressed, this.#commands.released, this.#keyTarget);
    signal.addEventListener('abort', stopKeys);
    this.views.rate.listen(this.layout.stage, signal);
    if (this.preferences.reducedMotion && !this.address.manual) {
      this.session.paused = true;
      this.#banner.show(words().motionPaused(resumeHint()), 'status');
    }
    const onReducedMotion = (wanted: boolean) => this.preferences.follow(wanted) && this.#showAppearance();
    listenToPage({ onHidden: () => this.#pauseHidden(), onReducedMotion }, signal);
    await this.views.show(this.views.renderer);
    if (signal.aborted) return;
    this.#offerHook();
    const loop = startLoop(
      (seconds) => this.#frame(seconds),
      (error) => {
        this.#broken = true;
        this.failures.report(error);
      },
    );
    signal.addEventListener('abort', loop.stop);
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    if (signal.aborted) return;
    if (!isPreview) await this.#openSidebar();
    else if (this.views.view !== undefined && !this.session.paused)
      startPreview(this.#game.controls, () => this.session.sim, this.#actions.reset, signal);
  }

  /** Ends the game: its loop, its listeners, its elements, its view and its world. */
  stop(): void {
    if (this.#end.signal.aborted) return;
    this.#end.abort();
    this.#controls?.destroy();
    this.sharing.destroy();
    this.#banner.hide();
    this.sidebar?.destroy();
    // A view that is being opened still reads the world.
    void this.views.destroy().finally(() => this.session.destroy());
  }

  async #openSidebar(): Promise<void> {
    const { createSidebar } = await import('./sidebar.ts');
    const sidebar = await createSidebar(this.layout.sidebar, {
      game: this.#game,
      values: this.session.values,
      actions: this.#actions,
      clip: this.sharing,
      set: (name, value) => this.failures.guard(() => this.#set(name, value)),
      sim: () => (this.session.started ? this.session.sim : undefined),
      plot: this.address.plot,
      report: (sentence) => this.#banner.add(sentence),
    });
    if (this.#end.signal.aborted) return sidebar.destroy();
    this.sidebar = sidebar;
    this.#applyAppearance();
    this.refresh();
  }

  #frame(seconds: number): void {
    const session = this.session;
    this.#sinceReset += seconds;
    if (this.#resetWanted && this.#sinceReset >= RESET_INTERVAL) this.reset();
    if (!session.started) return;
    this.#sinceStats += seconds;
    this.#controls?.poll();
    if (this.rewinding)
      this.#rewindBy(seconds * session.speed); // A closure here would allocate in every frame.
    else if (!this.#broken && !this.address.manual && !this.views.isLost) session.advance(seconds);
    // A player who rewound may play on, but the score is not ranked.
    this.#outcome?.show(this.#game.outcome?.(session.sim), !session.rewound);
    this.sidebar?.record(session.sim, session.isPast);
    const stands = (session.paused || this.address.manual) && !this.rewinding && session.sim.world.tick === this.#tick;
    const since = this.views.rate.next(seconds, stands);
    if (since >= 0) this.#draw(since);
    if (seconds > 0) this.#timing.add(FRAME, seconds * 1000);
    if (session.sim.world.tick !== this.#tick) this.#timing.add(STEP, session.stepTime);
    this.#tick = session.sim.world.tick;
    if (this.#sinceStats >= STATS_INTERVAL) this.#showStats();
  }

  #draw(seconds: number): void {
    const { view } = this.views;
    if (view === undefined || this.#broken) return;
    const start = performance.now();
    view.draw(this.session.alpha, seconds);
    this.#timing.add(DRAW, performance.now() - start);
    this.sharing.captureFrame(view.canvas);
  }

  #rewindBy = (seconds: number) => this.restorePast(() => this.session.rewind(seconds));

  /** A restored snapshot lies before the error. */
  restorePast(move: () => boolean): void {
    if (!move()) return;
    this.#controls?.restore();
    this.#broken = false;
    this.#sinceStats = STATS_INTERVAL;
    this.sidebar?.panel.refresh();
    this.views.refresh('setting');
  }

  /** Goes to a recorded moment and stays there. The state of an error is no moment to come back to. */
  #seek(moment: number): void {
    this.pause(true);
    this.failures.guard(() => this.restorePast(() => this.session.seekMoment(moment, !this.#broken)));
  }

  #showStats(): void {
    this.#sinceStats = 0;
    this.#timeline?.show();
    const { sim } = this.session;
    this.sidebar?.show(sim, countInto(this.#timing.copyTo(this.#stats), this.#game, sim));
  }

  /** Makes a world for the view of another renderer. @returns whether it could be made */
  #prepareWorld(dimensions: 2 | 3): boolean {
    this.sharing.dropClip(words().clipDropped);
    this.session.dimensions = dimensions;
    this.refresh();
    return this.failures.guard(() => this.replaceWorld(() => this.session.reset()));
  }

  reset(seed?: number): void {
    // A picture that is missing for want of a world comes with the world.
    if (this.views.lacksWorld) void this.views.show(this.views.wanted).then(() => this.#offerHook());
    else this.replaceWorld(() => this.session.reset(seed));
  }

  /** Replaces the world and shows the new one. */
  replaceWorld(make: () => void): void {
    this.#resetWanted = false;
    this.#sinceReset = 0;
    make();
    // A replay presses what was held then.
    if (!this.session.rewound) this.#controls?.renew();
    this.#outcome?.show(undefined);
    this.#broken = false;
    this.sidebar?.plot.clear();
    this.views.refresh('world');
  }

  #set(name: string, value: unknown): void {
    if (this.session.set(name, value)) this.#resetWanted = true;
    else this.views.refresh('setting');
    this.#onSetting();
  }

  toggle(name: string): void {
    this.failures.guard(() => this.#set(name, !this.session.values[name]));
    this.sidebar?.panel.refresh();
  }

  pause(paused = !this.session.paused): void {
    this.session.paused = paused;
    if (!paused && this.#banner.kind === 'status') this.#banner.hide();
    this.refresh();
  }

  /** Nobody plays a page that nobody sees; the player decides when the game goes on. */
  #pauseHidden(): void {
    if (this.session.paused || !this.session.started) return;
    this.pause(true);
    this.#controls?.releaseAll();
    if (this.#banner.text === '') this.#banner.show(words().hidden(resumeHint()), 'status');
  }

  refresh(): void {
    const { paused, speed } = this.session;
    const { reducedMotion, safeColors } = this.preferences;
    this.#toolbar.show({ paused, slow: speed !== 1, rewinding: this.rewinding, renderer: this.views.renderer });
    this.sidebar?.tools.show({ recording: this.sharing.isRecording, reducedMotion, safeColors });
    this.sidebar?.panel.refresh();
  }

  change(changes: Partial<AppearanceOptions>): void {
    this.preferences.set(changes);
    this.session.safeColors = this.preferences.safeColors;
    if (changes.safeColors !== undefined && this.session.started) this.session.applyColors();
    this.#showAppearance();
  }

  #showAppearance(): void {
    this.#applyAppearance();
    this.views.refresh('world');
    this.refresh();
  }

  #applyAppearance(): void {
    const { reducedMotion, safeColors } = this.preferences;
    this.layout.root.toggleAttribute('data-reduced-motion', reducedMotion);
    this.layout.root.toggleAttribute('data-safe-colors', safeColors);
    this.session.safeColors = safeColors;
    if (this.sidebar !== undefined) this.sidebar.plot.safeColors = safeColors;
  }

  /** Starts another game after the end of one, with the next seed so that it differs. */
  #playAgain(): void {
    const { sim, seed } = this.session;
    const next = this.#game.outcome?.(sim)?.nextSeed ?? (seed + 1) % 2 ** 32;
    this.failures.guard(() => this.reset(next));
    this.views.view?.canvas.focus();
  }

  #makeSharing(): Sharing {
    return new Sharing({
      title: this.#game.title,
      root: this.layout.root,
      banner: this.#banner,
      failures: this.failures,
      picture: () => {
        const { view } = this.views;
        if (view === undefined) return undefined;
        this.#draw(0);
        return { canvas: view.canvas, time: this.session.sim.world.time };
      },
      link: () => {
        const { values, seed } = this.session;
        const shown = { values, seed, renderer: this.views.renderer, plot: this.sidebar?.plot.choice };
        return this.#place.link?.() ?? writeAddress(location.href, this.#game.settings, shown);
      },
      onChange: () => this.refresh(),
      onClip: () => this.session.paused && !this.address.manual && this.pause(false),
    });
  }

  #offerHook(): void {
    const { signal } = this.#end;
    if (this.session.started && !signal.aborted) offerHook(this.#createHook(), signal);
  }

  #createHook(): GameHook {
    const page = () => ({
      view: this.views.view,
      ready: this.views.view !== undefined && this.sidebar !== undefined,
      renderer: this.views.renderer,
      reducedMotion: this.preferences.reducedMotion,
      recording: this.sharing.isRecording,
      plot: this.sidebar?.plot.choice,
      banner: this.#banner.text,
      timing: this.#timing.copyTo({ frame: 0, step: 0, draw: 0 }),
    });
    const record = () => this.sidebar?.record(this.session.sim, false);
    return createHook(this.session, page, (move) => this.restorePast(move), record, {
      reset: (seed) => this.reset(seed),
      set: (name, value) => {
        this.#set(name, value);
        if (this.#resetWanted) this.reset();
        this.sidebar?.panel.refresh();
      },
      pause: () => this.pause(true),
      resume: () => this.pause(false),
      show: (renderer) => this.views.show(renderer),
    });
  }
}
