import { createRunner, destroyWorld, keepState, type Runner, step } from '@principia/physics';
import { type Dragging, dragBodies } from './dragging.ts';
import type { GameDefinition, Simulation } from './game.ts';
import { History } from './history.ts';
import { checkValue, type Settings, type ValuesOf } from './settings.ts';

/** Longest real time that one frame may catch up with, s: a slow machine shows slow motion instead of freezing. */
const MAX_FRAME = 1 / 15;
/** Milliseconds that the steps of one frame may take; beyond it a frame gets one step. */
const STEPS_BUDGET = 50;

/** A running game without a page: its world, its settings and its clock. */
export class Session<S extends Settings, Sim extends Simulation> {
  /** What is played. */
  readonly game: GameDefinition<S, Sim>;
  /** The present settings; `set` changes them. */
  readonly values: ValuesOf<S>;
  /** Seed of the present world, and of the next one unless `reset` gets another. */
  seed: number;
  /** Dimensions of the next world. */
  dimensions: 2 | 3 = 2;
  /** Whether `advance` takes no steps. */
  paused = false;
  /** Simulated seconds per real second; below one is slow motion. */
  speed = 1;
  /** Milliseconds that the last step took. */
  stepTime = 0;
  /** Number of steps in the last frame. */
  steps = 0;
  /** Bodies use the colour-blind palette. */
  safeColors = false;
  /** Called after each step; default nothing. */
  afterStep = () => {};
  #sim: Sim | undefined;
  #dragging: Dragging | undefined;
  #runner: Runner | undefined;
  #history: History | undefined;
  /** Simulated time that rewinding has reached, s; it may lie between two snapshots. */
  #rewindTime: number | undefined;
  #steppedManually = false;
  /** The attempt in which the player rewound last; undefined before. */
  #rewoundAttempt: number | undefined;
  /** The palette that was applied last. */
  readonly #appliedColors = { safe: false };
  readonly #clock: () => number;

  /** There is no world before `reset`. @param clock milliseconds, for measuring steps; default `performance.now` */
  constructor(game: GameDefinition<S, Sim>, values: ValuesOf<S>, seed: number, clock = () => performance.now()) {
    this.game = game;
    this.values = values;
    this.seed = seed;
    this.#clock = clock;
  }

  /** Whether there is a world. */
  get started(): boolean {
    return this.#sim !== undefined;
  }

  /** The present world. @throws Error before the first `reset` and after `destroy` */
  get sim(): Sim {
    if (this.#sim === undefined) throw new Error('The game has not started yet.');
    return this.#sim;
  }

  /** Whether the player rewound this game, or this attempt of one that has several, or watches a replay. */
  get rewound(): boolean {
    return this.#rewoundAttempt !== undefined && this.#rewoundAttempt === this.#attempt;
  }

  get #attempt(): number {
    return this.game.attempt?.(this.sim) ?? 0;
  }

  /** The bodies that pointers drag. @throws Error before the first `reset` and after `destroy` */
  get dragging(): Dragging {
    if (this.#dragging === undefined) throw new Error('The game has not started yet.');
    return this.#dragging;
  }

  /** Position of the picture between the last two steps; 1 after a single step. */
  get alpha(): number {
    return this.#steppedManually ? 1 : (this.#runner?.alpha ?? 1);
  }

  /** Creates a new world from the present seed and settings. The old one stays if this fails. */
  reset(seed = this.seed): void {
    const { values, dimensions } = this;
    this.#install(this.game.create({ values: { ...values }, seed, dimensions }), seed);
  }

  /** Replays the present game from its beginning. A replay counts as rewound. */
  replay(): void {
    const sim = this.game.replay?.(this.sim);
    if (sim === undefined) return;
    this.#install(sim, this.seed);
    this.#rewoundAttempt = this.#attempt;
  }

  #install(sim: Sim, seed: number): void {
    if (this.#sim !== undefined) destroyWorld(this.#sim.world);
    this.seed = seed;
    this.#sim = sim;
    this.applyColors();
    const limit = this.game.dragLimit?.(sim);
    const maxSpeed = this.game.dragSpeed?.(sim);
    const { drag = dragBodies } = this.game;
    this.#dragging = drag(sim.world, {
      ...(limit === undefined ? {} : { limit }),
      ...(maxSpeed === undefined ? {} : { maxSpeed }),
    });
    this.#runner = createRunner(sim.world, {
      dt: sim.dt,
      maxFrame: Math.max(MAX_FRAME, sim.dt),
      afterStep: () => this.afterStep(),
    });
    this.#steppedManually = true;
    this.#rewoundAttempt = undefined;
    this.#rewindTime = undefined;
    keepState(sim.world, this.values, this.#appliedColors);
    this.#history = new History(sim, this.#clock, this.game.rewindSeconds?.(sim));
  }

  /** Gives the world back. */
  destroy(): void {
    if (this.#sim !== undefined) destroyWorld(this.#sim.world);
    this.#sim = undefined;
    this.#runner = undefined;
    this.#history = undefined;
    this.#dragging = undefined;
  }

  /** Assigns colours to the bodies. */
  applyColors(): void {
    this.#appliedColors.safe = this.safeColors;
    this.game.applyColors?.(this.sim, { seed: this.seed, safeColors: this.safeColors });
  }

  /** Time of the world, s; zero before there is one. */
  get time(): number {
    return this.#sim?.world.time ?? 0;
  }

  /** Simulated seconds that can be rewound. */
  get historySeconds(): number {
    return this.#history === undefined ? 0 : this.sim.world.time - this.#history.timeAt(0);
  }

  /** Number of recorded moments. */
  get moments(): number {
    return this.#history?.count ?? 1;
  }

  /** Index of the recorded moment that the world stands at or came from last. */
  get moment(): number {
    return this.#history?.index ?? 0;
  }

  /** Whether the world stands at a moment after which others are recorded; the next step discards those. */
  get isPast(): boolean {
    return this.#history?.hasLater === true;
  }

  /**
   * Rewinds by `seconds` of simulated time. Successive calls accumulate until `advance` or `step` is called.
   * @returns whether the world changed
   */
  rewind(seconds: number): boolean {
    const { world } = this.sim;
    const history = this.#history as History;
    this.#rewindTime = Math.max(history.timeAt(0), (this.#rewindTime ?? world.time) - seconds);
    return this.#restored(history.restoreTo(this.#rewindTime));
  }

  /**
   * Restores the last recorded moment not after a time, s. Later ones are kept until the world steps on.
   * @param keepsPresent whether one can come back to the present moment; default true
   * @returns whether the world changed
   */
  seek(time: number, keepsPresent = true): boolean {
    this.#rewindTime = undefined;
    return this.#restored((this.#history as History).seek(time, keepsPresent));
  }

  /** Goes to a recorded moment. @returns whether the world changed */
  seekMoment(index: number, keepsPresent = true): boolean {
    const history = this.#history as History;
    return this.seek(history.timeAt(Math.max(0, Math.min(index, history.count - 1))), keepsPresent);
  }

  #restored(changed: boolean): boolean {
    // Bodies that were dragged at that time are released as well.
    if (changed) this.dragging.dropAll();
    else this.dragging.releaseAll();
    if (this.#appliedColors.safe !== this.safeColors) this.applyColors();
    this.#steppedManually = true;
    if (changed) this.#rewoundAttempt = this.#attempt;
    return changed;
  }

  /**
   * Goes back by one step, or, where a player acted since the last recorded moment, to that moment: what a player does is
   * not recorded, and the steps cannot be repeated then. @returns whether the world changed
   */
  stepBack(): boolean {
    this.#rewindTime = undefined;
    return this.#restored((this.#history as History).stepBack());
  }

  /**
   * Changes a setting.
   * @returns whether the world must be recreated; the caller then calls `reset`
   * @throws Error with a sentence if there is no such setting or the value is invalid
   */
  set(name: string, value: unknown): boolean {
    const setting = Object.hasOwn(this.game.settings, name) ? this.game.settings[name] : undefined;
    if (setting === undefined) {
      throw new Error(`There is no setting “${name}”. The settings are ${Object.keys(this.game.settings).join(', ')}.`);
    }
    const values = this.values as Record<string, unknown>;
    values[name] = checkValue(name, setting, value);
    return this.#sim === undefined || !this.game.apply(this.#sim, name, this.values);
  }

  /** Takes `count` steps at once, even while paused. */
  step(count = 1): void {
    const { world, dt } = this.sim;
    const start = this.#clock();
    for (let i = 0; i < count; i++) {
      step(world, dt);
      this.#history?.record();
      this.afterStep();
    }
    this.#rewindTime = undefined;
    this.#measureStep(start, count);
    this.#steppedManually = true;
  }

  /** Advances by `seconds` of real time. */
  advance(seconds: number): void {
    if (this.paused || this.#runner === undefined || this.game.hasEnded?.(this.sim) === true) {
      this.dragging.place();
      this.steps = 0;
      return;
    }
    this.#rewindTime = undefined;
    const start = this.#clock();
    const maxSteps = Math.max(1, Math.floor(STEPS_BUDGET / Math.max(this.stepTime, 1e-3)));
    const maxSeconds = maxSteps * this.#runner.dt;
    // The argument is passed on unchanged where possible, because a computed number would be allocated on the heap.
    const isUnchanged = this.speed === 1 && seconds <= maxSeconds;
    this.steps = this.#runner.advance(isUnchanged ? seconds : Math.min(seconds * this.speed, maxSeconds));
    this.#measureStep(start, this.steps);
    if (this.steps === 0) return;
    this.#steppedManually = false;
    this.#history?.record();
  }

  #measureStep(start: number, steps: number): void {
    if (steps > 0) this.stepTime = (this.#clock() - start) / steps;
  }
}
