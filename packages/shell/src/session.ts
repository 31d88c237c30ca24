import { createRunner, destroyWorld, keepState, type Runner, step } from '@principia/physics';
import type { GameDefinition, Simulation } from './game.ts';
import { History } from './history.ts';
import { type Holding, holdBodies } from './holding.ts';
import { checkValue, type Settings, type ValuesOf } from './settings.ts';

/** Longest real time one frame may make up for, s: a slow machine gets slow motion, not a frozen page. */
const LONGEST_FRAME = 1 / 15;
/** Milliseconds of steps in a frame from which on one step must do. */
const STEPS_BUDGET = 50;

/** A game being played, without a page: its world, its values and its clock. */
export class Session<S extends Settings, Sim extends Simulation> {
  readonly game: GameDefinition<S, Sim>;
  readonly values: ValuesOf<S>;
  seed: number;
  dimensions: 2 | 3 = 2;
  paused = false;
  /** Simulated seconds a real second; below one is slow motion. */
  speed = 1;
  /** Milliseconds the last step took. */
  stepTime = 0;
  /** Steps of the last frame. */
  steps = 0;
  /** The player went back in time in this game, or watches an old one. */
  rewound = false;
  /** Bodies wear colours that everybody tells apart. */
  safeColors = false;
  #sim: Sim | undefined;
  #holding: Holding | undefined;
  #runner: Runner | undefined;
  #history: History | undefined;
  /** Simulated time that going back has reached, s; between two moments that are kept it is none of them. */
  #backTime: number | undefined;
  #steppedByHand = false;
  /** How bodies were dressed last. */
  readonly #dressed = { safely: false };
  readonly #clock: () => number;

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

  get sim(): Sim {
    if (this.#sim === undefined) throw new Error('The game has not started yet.');
    return this.#sim;
  }

  get holding(): Holding {
    if (this.#holding === undefined) throw new Error('The game has not started yet.');
    return this.#holding;
  }

  /** Where between the last two steps the picture is; after a single step it shows that step. */
  get alpha(): number {
    return this.#steppedByHand ? 1 : (this.#runner?.alpha ?? 1);
  }

  /** A new world from the present seed and values. The old one stays when the new one cannot be made. */
  reset(seed = this.seed): void {
    const { values, dimensions } = this;
    this.#install(this.game.create({ values: { ...values }, seed, dimensions }), seed);
  }

  /** Plays the present game again from its beginning. What comes of it is no new game. */
  replay(): void {
    const sim = this.game.replay?.(this.sim);
    if (sim === undefined) return;
    this.#install(sim, this.seed);
    this.rewound = true;
  }

  #install(sim: Sim, seed: number): void {
    if (this.#sim !== undefined) destroyWorld(this.#sim.world);
    this.seed = seed;
    this.#sim = sim;
    this.dress();
    const limit = this.game.holdLimit?.(sim);
    this.#holding = holdBodies(sim.world, limit === undefined ? {} : { limit });
    this.#runner = createRunner(sim.world, { dt: sim.dt, maxFrame: Math.max(LONGEST_FRAME, sim.dt) });
    this.#steppedByHand = true;
    this.rewound = false;
    this.#backTime = undefined;
    keepState(sim.world, this.values, this.#dressed);
    this.#history = new History(sim, this.#clock);
  }

  /** Gives the bodies their colours. */
  dress(): void {
    this.#dressed.safely = this.safeColors;
    this.game.dress?.(this.sim, { seed: this.seed, safeColors: this.safeColors });
  }

  /** Simulated seconds that the player can go back. */
  get past(): number {
    return this.#history?.length ?? 0;
  }

  /**
   * Goes back by `seconds` of simulated time, call by call, in the moments that are kept, until `advance` or `step` goes on.
   * @returns whether the world changed
   */
  rewind(seconds: number): boolean {
    const { world } = this.sim;
    const history = this.#history as History;
    this.#backTime = Math.max(world.time - history.length, (this.#backTime ?? world.time) - seconds);
    const changed = history.backTo(this.#backTime);
    // Bodies held then are let go as well.
    if (changed) this.holding.dropAll();
    else this.holding.releaseAll();
    if (this.#dressed.safely !== this.safeColors) this.dress();
    this.#steppedByHand = true;
    this.rewound ||= changed;
    return changed;
  }

  /** Goes back to the moment kept before the present one. @returns whether there was one */
  stepBack(): boolean {
    this.#backTime = undefined;
    return this.rewind(this.sim.dt);
  }

  /**
   * Changes one setting.
   * @returns whether the world has to be made anew: call `reset` when it is time to
   * @throws Error with a sentence when there is no such setting or it does not take the value
   */
  set(name: string, value: unknown): boolean {
    const setting = Object.hasOwn(this.game.settings, name) ? this.game.settings[name] : undefined;
    if (setting === undefined) {
      throw new Error(`There is no setting “${name}”. There are ${Object.keys(this.game.settings).join(', ')}.`);
    }
    const values = this.values as Record<string, unknown>;
    values[name] = checkValue(name, setting, value);
    return this.#sim === undefined || !this.game.apply(this.#sim, name, this.values);
  }

  /** `count` steps at once, whether paused or not. */
  step(count = 1): void {
    const { world, dt } = this.sim;
    const start = this.#clock();
    for (let i = 0; i < count; i++) {
      step(world, dt);
      this.#history?.note();
    }
    this.#backTime = undefined;
    this.#note(start, count);
    this.#steppedByHand = true;
  }

  /** Lets `seconds` of real time pass. */
  advance(seconds: number): void {
    if (this.paused || this.#runner === undefined) {
      this.holding.place();
      this.steps = 0;
      return;
    }
    this.#backTime = undefined;
    const start = this.#clock();
    const most = Math.max(1, Math.floor(STEPS_BUDGET / Math.max(this.stepTime, 1e-3)));
    const longest = most * this.#runner.dt;
    // Handed on as it came, where it may be: a number that is worked out is garbage by the next frame.
    const asItCame = this.speed === 1 && seconds <= longest;
    this.steps = this.#runner.advance(asItCame ? seconds : Math.min(seconds * this.speed, longest));
    this.#note(start, this.steps);
    if (this.steps === 0) return;
    this.#steppedByHand = false;
    this.#history?.note();
  }

  #note(start: number, steps: number): void {
    if (steps > 0) this.stepTime = (this.#clock() - start) / steps;
  }
}
