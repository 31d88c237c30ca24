/** The simulation: the scene, its rules and its inputs. Needs no screen; the same seed and log give the same game. */
import { stateHash } from '@principia/physics';
import { type BlackHole, blackHole, InputLog, type LoggedInput } from '@principia/scenes';
import { Autopilot } from './autopilot.ts';
import type { Heading } from './heading.ts';
import { type RuleOptions, Rules } from './rules.ts';

/** What a player can do: push one way, stop pushing, ask for other holes. */
export type Input = Heading | 'release' | 'redraw';

export interface BlackHoleValues extends RuleOptions {
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
  #pilot: Autopilot;
  #idle = 0;
  readonly #seed: number;

  constructor({ values, seed, log }: BlackHoleOptions) {
    this.scene = blackHole.create({ seed });
    this.rules = new Rules(this.scene, values);
    this.log = new InputLog(log);
    this.autopilot = values.autopilot;
    this.#seed = seed;
    this.#pilot = new Autopilot(this.scene, seed);
    const { phases } = this.world;
    phases.input.unshift((world, dt) => {
      this.log.take(world.tick, (input) => this.#take(input));
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

  /** What the player does; the next step takes it. */
  press(input: Input): void {
    this.log.add(input);
  }

  /** Two games with equal hashes go on alike. */
  hash(): string {
    const { phase, lives, score, bonus, dodged, redraws, fuel, slings } = this.rules;
    return `${stateHash(this.world)} ${phase} ${[lives, score, bonus, dodged, redraws, fuel, slings].join(' ')}`;
  }

  /** Notes all that is not in the world; returns what puts it back when the world is restored. */
  remember(): () => void {
    const { autopilot, isDemo } = this;
    const [pilot, idle] = [this.#pilot, this.#idle];
    const parts = [this.scene, this.rules, this.log, pilot].map((part) => part.remember());
    return () => {
      Object.assign(this, { autopilot, isDemo });
      this.#pilot = pilot;
      this.#idle = idle;
      for (const putBack of parts) putBack();
    };
  }

  #take(input: Input): void {
    if (this.isDemo) this.#endDemo();
    this.#idle = 0;
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

  #fly(dt: number): void {
    const { rules } = this;
    if (!this.autopilot && !this.isDemo) {
      if (rules.phase !== 'ready') return;
      this.#idle += dt;
      if (this.#idle < IDLE_SECONDS) return;
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
    this.#pilot = new Autopilot(this.scene, this.#seed);
  }
}

export function createGame(options: BlackHoleOptions): BlackHoleGame {
  return new BlackHoleGame(options);
}

/** Gives the running game a changed setting; false where only a new one can have it. */
export function applyValue(sim: BlackHoleGame, name: string, values: BlackHoleValues): boolean {
  if (name === 'autopilot') {
    sim.autopilot = values.autopilot;
    sim.rules.heading = undefined;
  } else if (name === 'fuel') {
    sim.rules.options = { ...sim.rules.options, fuel: values.fuel };
  } else {
    return name !== 'moving';
  }
  return true;
}
