/** The simulation: the scene, its rules and its inputs. Needs no screen; the same seed and log give the same game. */
import { keepState, markImmutable, stateHash } from '@principia/physics';
import { type BlackHole, blackHole, InputLog, type LoggedInput } from '@principia/scenes';
import { Autopilot } from './autopilot.ts';
import type { Heading } from './heading.ts';
import { type RuleOptions, Rules } from './rules.ts';

/** What a player can do: push one way, stop pushing, ask for other holes; and the switches that change the game. */
export type Input = Heading | 'release' | 'redraw' | Switch;

/** Switches are inputs too, so that a log plays the whole game again. */
const SWITCHES = ['autopilot', 'no autopilot', 'fuel', 'no fuel'] as const;
type Switch = (typeof SWITCHES)[number];

const isSwitch = (input: Input): input is Switch => (SWITCHES as readonly string[]).includes(input);

export interface BlackHoleValues extends RuleOptions {
  /** The holes pull after Paczyński and Wiita. */
  readonly steep: boolean;
  readonly autopilot: boolean;
}

export interface BlackHoleOptions {
  readonly values: BlackHoleValues;
  readonly seed: number;
  /** Inputs of an earlier game to play again. */
  readonly log?: readonly LoggedInput<Input>[];
}

/** Seconds without any input after which the game plays itself. */
export const IDLE_SECONDS = 12;

export class BlackHoleGame {
  readonly scene: BlackHole;
  readonly rules: Rules;
  readonly log: InputLog<Input>;
  /** The computer plays: somebody switched it on, or nobody has touched anything for a while. */
  autopilot: boolean;
  isDemo = false;
  readonly #pilot: Autopilot;
  /** Seconds without input: in a cell, which snapshots copy without garbage. */
  readonly #idle = new Float64Array(1);
  readonly #seed: number;
  readonly #values: BlackHoleValues;

  constructor({ values, seed, log }: BlackHoleOptions) {
    this.#values = { fuel: values.fuel, moving: values.moving, steep: values.steep, autopilot: values.autopilot };
    // Its own state is kept; the rest of it stays.
    this.scene = markImmutable(blackHole.create({ seed, steep: values.steep ? 1 : 0 }));
    this.rules = new Rules(this.scene, this.#values);
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

  get world() {
    return this.scene.world;
  }

  get dt() {
    return this.scene.dt;
  }

  /** What the player does; the next step takes it. Who takes part in a replay plays on from there. */
  press(input: Input): void {
    this.log.endScript();
    this.log.add(input);
  }

  /** This is an earlier game, played from its log. */
  get isReplay(): boolean {
    return this.log.isScripted;
  }

  /** The same game from its beginning, played from the log so far. */
  again(): BlackHoleGame {
    return new BlackHoleGame({ values: this.#values, seed: this.#seed, log: this.log.entries });
  }

  /** Two games with equal hashes go on alike. */
  hash(): string {
    const { phase, lives, score, bonus, dodged, redraws, fuel, slings } = this.rules;
    return `${stateHash(this.world)} ${phase} ${[lives, score, bonus, dodged, redraws, fuel, slings].join(' ')}`;
  }

  #take(input: Input): void {
    if (isSwitch(input)) {
      this.#turn(input);
      return;
    }
    if (this.isDemo) this.#endDemo();
    this.#idle[0] = 0;
    if (input === 'redraw') {
      this.rules.redraw();
    } else if (input === 'release') {
      this.rules.heading = undefined;
    } else {
      this.rules.launch();
      // The last one pressed decides, whatever else is held.
      if (this.rules.phase === 'flying') this.rules.heading = input;
    }
  }

  #turn(input: Switch): void {
    const { rules } = this;
    if (input === 'fuel' || input === 'no fuel') {
      rules.options = { ...rules.options, fuel: input === 'fuel' };
      return;
    }
    this.autopilot = input === 'autopilot';
    rules.heading = undefined;
  }

  #fly(dt: number): void {
    const { rules } = this;
    if (!this.autopilot && !this.isDemo) {
      if (rules.phase !== 'ready') return;
      this.#idle[0] += dt;
      if (this.#idle[0] < IDLE_SECONDS) return;
      this.isDemo = true;
    }
    if (this.isDemo && rules.phase === 'over') rules.restart();
    rules.launch();
    if (rules.phase === 'flying') rules.heading = this.#pilot.steer(dt);
  }

  /** Somebody wants to play: from the beginning. */
  #endDemo(): void {
    this.isDemo = false;
    this.rules.heading = undefined;
    this.rules.restart();
    this.#pilot.begin(this.#seed);
  }
}

export function createGame(options: BlackHoleOptions): BlackHoleGame {
  return new BlackHoleGame(options);
}

/** Gives the running game a changed setting; false where only a new one can have it. */
export function applyValue(sim: BlackHoleGame, name: string, values: BlackHoleValues): boolean {
  if (name === 'autopilot') sim.press(values.autopilot ? 'autopilot' : 'no autopilot');
  else if (name === 'fuel') sim.press(values.fuel ? 'fuel' : 'no fuel');
  else return name !== 'moving' && name !== 'steep';
  return true;
}
