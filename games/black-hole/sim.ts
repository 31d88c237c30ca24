/**
 * The simulation: the scene, its rules and its inputs. It needs no display; the same seed and log give the same game.
 */
import { keepState, markImmutable, stateHash } from '@principia/physics';
import { type BlackHole, blackHole, InputLog, type LoggedInput } from '@principia/scenes';
import { Autopilot } from './autopilot.ts';
import { DIRECTIONS, type Heading, type Push, pushOf } from './heading.ts';
import { type RuleOptions, Rules } from './rules.ts';

/**
 * The player's inputs: full thrust in a direction, analogue thrust, stop, change the layout; and the switches that affect
 * the game.
 */
export type Input = Heading | Push | 'release' | 'redraw' | Switch;

/** Switches are inputs too, so that a log reproduces the whole game. */
const SWITCHES = ['autopilot', 'no autopilot', 'fuel', 'no fuel'] as const;
type Switch = (typeof SWITCHES)[number];

const isSwitch = (input: Input): input is Switch => (SWITCHES as readonly unknown[]).includes(input);

export interface BlackHoleValues extends RuleOptions {
  /** Uses the Paczyński–Wiita potential. */
  readonly steep: boolean;
  readonly autopilot: boolean;
}

export interface BlackHoleOptions {
  readonly values: BlackHoleValues;
  readonly seed: number;
  /** Inputs of an earlier game to replay. */
  readonly log?: readonly LoggedInput<Input>[];
}

/** Seconds without any input after which the demo starts. */
export const IDLE_SECONDS = 12;

export class BlackHoleGame {
  readonly scene: BlackHole;
  readonly rules: Rules;
  readonly log: InputLog<Input>;
  /** Whether the autopilot flies; a demo, in which it flies too, starts after some time without input. */
  autopilot: boolean;
  isDemo = false;
  readonly #pilot: Autopilot;
  /** Seconds without input. A typed array, because snapshots copy it without garbage. */
  readonly #idle = new Float64Array(1);
  readonly #seed: number;
  readonly #values: BlackHoleValues;

  constructor({ values, seed, log }: BlackHoleOptions) {
    const { fuel, moving, steep, autopilot, level } = values;
    this.#values = { fuel, moving, steep, autopilot, ...(level === undefined ? {} : { level }) };
    // The scene registers its own mutable state.
    this.scene = markImmutable(blackHole.create({ seed, steep: values.steep ? 1 : 0 }));
    this.rules = new Rules(this.scene, this.#values);
    this.rules.restart();
    this.log = new InputLog(log);
    this.autopilot = values.autopilot;
    this.#seed = seed;
    this.#pilot = new Autopilot(this.scene, seed);
    keepState(this.world, this, this.#idle, this.log.state);
    const take = (input: Input) => this.#take(input);
    const { phases } = this.world;
    phases.input.unshift((world, dt) => {
      this.log.take(world.tick, take);
      this.#fly(dt);
      this.rules.steer(dt);
    });
    phases.events.push(() => this.rules.judge());
  }

  get seed(): number {
    return this.#seed;
  }

  get world() {
    return this.scene.world;
  }

  get dt() {
    return this.scene.dt;
  }

  /** Adds an input for the next step. An input during a replay ends the replay and continues from there. */
  press(input: Input): void {
    this.log.endScript();
    this.log.add(input);
  }

  /** Thrust by a stick or pointer: fractions of full thrust, y up; (0, 0) stops the engine. */
  steer(x: number, y: number): void {
    this.press(pushOf(x, y) ?? 'release');
  }

  /** Switches an engine off that a restored moment has on, unless the log of an earlier game does so. */
  letGo(): void {
    const isFlownByPlayer = !this.isReplay && !this.isDemo && !this.autopilot;
    if (this.rules.push !== undefined && isFlownByPlayer) this.press('release');
  }

  /** Whether the inputs come from the log of an earlier game. */
  get isReplay(): boolean {
    return this.log.isScripted;
  }

  /** Creates the same game from its beginning and replays the log so far. */
  again(): BlackHoleGame {
    return new BlackHoleGame({ values: this.#values, seed: this.#seed, log: this.log.entries });
  }

  /** Hash of the state; games with equal hashes evolve equally. */
  hash(): string {
    const { phase, lives, score, bonus, dodged, redraws, fuel, slings } = this.rules;
    return `${stateHash(this.world)} ${phase} ${[lives, score, bonus, dodged, redraws, fuel, slings].join(' ')}`;
  }

  #take(input: Input): void {
    if (isSwitch(input)) {
      this.#applySwitch(input);
      return;
    }
    if (this.isDemo) this.#endDemo();
    this.#idle[0] = 0;
    if (input === 'redraw') {
      this.rules.redraw();
    } else if (input === 'release') {
      this.rules.push = undefined;
    } else {
      this.rules.launch();
      // The last key pressed counts, even while others are held.
      if (this.rules.phase === 'flying')
        this.rules.push = markImmutable(typeof input === 'string' ? DIRECTIONS[input] : input);
    }
  }

  #applySwitch(input: Switch): void {
    const { rules } = this;
    if (input === 'fuel' || input === 'no fuel') {
      rules.options = { ...rules.options, fuel: input === 'fuel' };
      return;
    }
    this.autopilot = input === 'autopilot';
    rules.push = undefined;
  }

  #fly(dt: number): void {
    const { rules } = this;
    if (!this.autopilot && !this.isDemo) {
      if (rules.phase !== 'ready' || rules.hasBegun) return;
      this.#idle[0] += dt;
      if (this.#idle[0] < IDLE_SECONDS) return;
      this.isDemo = true;
    }
    if (this.isDemo && rules.phase === 'over') rules.restart();
    rules.launch();
    if (rules.phase !== 'flying') return;
    rules.record.markAssisted();
    rules.isAssisted = true;
    const heading = this.#pilot.steer(dt);
    rules.push = heading === undefined ? undefined : DIRECTIONS[heading];
  }

  /** Ends the demo and starts a new game. */
  #endDemo(): void {
    this.isDemo = false;
    this.rules.restart();
    this.#pilot.begin(this.#seed);
  }
}

export function createGame(options: BlackHoleOptions): BlackHoleGame {
  return new BlackHoleGame(options);
}

/** Applies a changed setting to the running game; false if the setting requires a new game. */
export function applyValue(sim: BlackHoleGame, name: string, values: BlackHoleValues): boolean {
  if (name === 'autopilot') sim.press(values.autopilot ? 'autopilot' : 'no autopilot');
  else if (name === 'fuel') sim.press(values.fuel ? 'fuel' : 'no fuel');
  else return name !== 'moving' && name !== 'steep' && name !== 'level';
  return true;
}
