/**
 * The simulation: the scene, the player's inputs, and shows. It needs no display; the same seed and log give the same
 * game.
 */
import { createRandom, keepState, markImmutable, stateHash } from '@principia/physics';
import {
  FIREWORKS_REACH,
  FIREWORKS_SKY,
  type Fireworks,
  fireworks,
  heldStars,
  InputLog,
  type LoggedInput,
  maxHoldSeconds,
  SHELL_NAMES,
  SHELLS,
  type ShellOrder,
  STAR_COLORS,
} from '@principia/scenes';

/** Index of a kind or colour that is chosen at random at launch. */
export const RANDOM = -1;

/** The kind that is not launched but ignited at the pointer, after whole seconds of holding. */
export const SWARM = SHELLS.findIndex(({ isHeld }) => isHeld);
/** Number of shell kinds that a click may launch; a random launch chooses one of them. */
export const RANDOM_KINDS = SHELL_NAMES.length - 1;

/** Directions in which keys move the crosshair. */
export type Direction = 'up' | 'left' | 'down' | 'right';

/** A shell of a show with its time. */
export interface Cue extends ShellOrder {
  /** Time of launch, steps after the start of the show. */
  readonly tick: number;
}

/** The player's inputs; kind and colour may be `RANDOM`. */
export type Input =
  | { readonly do: 'hold'; readonly finger: number }
  | ({ readonly do: 'fire'; readonly finger: number; readonly x: number; readonly y: number; readonly z: number } & {
      readonly kind: number;
      readonly color: number;
    })
  /** A shell whose stars form a text, given by its points, so that a replay needs no font. */
  | ({ readonly do: 'write'; readonly points: readonly number[] } & Omit<ShellOrder, 'kind' | 'points'>)
  | { readonly do: 'forget'; readonly finger: number }
  | { readonly do: 'steer'; readonly way: Direction; readonly on: boolean }
  | { readonly do: 'play'; readonly cues: readonly Cue[] }
  | { readonly do: 'stop' }
  | { readonly do: 'wind'; readonly speed: number }
  | { readonly do: 'colors'; readonly colors: readonly number[] };

export interface FireworksValues {
  readonly wind: number;
  readonly barrage: boolean;
  readonly sparks: number;
}

export interface FireworksOptions {
  readonly values: FireworksValues;
  readonly seed: number;
  readonly dimensions: 2 | 3;
  /** The show that plays from the first step. */
  readonly opening?: readonly Cue[];
  /** A demo ends when the player fires, and repeats when it is over. */
  readonly isDemo?: boolean;
  /** Inputs of an earlier game to replay. */
  readonly log?: readonly LoggedInput<Input>[];
}

/** Largest number of shells in the air. */
const SHELLS_IN_AIR = 28;
/** Seconds of holding for the largest shell, and the power of a click. */
export const MAX_HOLD_SECONDS = 1.6;
const CLICK_POWER = 0.35;

/** Speed of the crosshair, m/s. */
const CROSSHAIR_SPEED = 30;
/** Steps from the end of the demo to its next start. */
const DEMO_PAUSE = 300;

export class FireworksGame {
  readonly scene: Fireworks;
  readonly log: InputLog<Input>;
  /** World time at which each pointer was pressed. */
  readonly held = new Map<number, number>();
  /** The show being played. */
  show: readonly Cue[] = [];
  showStart = 0;
  /** Shells that were not launched because no mortar was free. */
  refused = 0;
  fired = 0;
  isDemo: boolean;
  /** Whether shells use the colour-blind palette. */
  usesSafeColors = false;
  /** Target of keyboard and gamepad, m; visible once it was moved. */
  readonly crosshair = { x: 0, y: 32, z: 0, isShown: false };
  readonly #pressedKeys: Record<Direction, boolean> = { up: false, left: false, down: false, right: false };
  /** Index of the next cue. */
  readonly #progress = { next: 0 };
  readonly #random;

  constructor({ values, seed, dimensions, opening = [], isDemo = false, log }: FireworksOptions) {
    const { wind, barrage, sparks } = values;
    // The scene registers its own mutable state.
    this.scene = markImmutable(
      fireworks.create({ seed, dimensions, wind, shells: SHELLS_IN_AIR, count: barrage ? sparks : 0 }),
    );
    this.log = new InputLog(log);
    this.#random = createRandom(seed, 2);
    this.show = markImmutable(opening);
    this.isDemo = isDemo;
    keepState(this.world, this, this.#pressedKeys, this.#progress, this.#random.state, this.log.state);
    const take = (input: Input) => this.#take(input);
    this.world.phases.input.unshift((world) => {
      this.log.take(world.tick, take);
      this.#moveCrosshair();
      this.#playShow();
    });
  }

  get world() {
    return this.scene.world;
  }

  get dt() {
    return this.scene.dt;
  }

  /** Whether the show has remaining cues. */
  get isShowing(): boolean {
    return this.#progress.next < this.show.length;
  }

  /** Adds an input for the next step. */
  press(input: Input): void {
    this.log.add(input);
  }

  /** Lets go of the keys that a restored moment has down. */
  letGo(): void {
    for (const [way, on] of Object.entries(this.#pressedKeys)) {
      if (on) this.press({ do: 'steer', way: way as Direction, on: false });
    }
  }

  /** Power of the shell that a pointer holds, 0 to 1. @param kind index of the chosen kind */
  powerOf(finger: number, kind: number): number {
    const since = this.#heldSince(finger);
    if (kind === SWARM) return this.#wholeSeconds(since) / maxHoldSeconds(SHELLS[SWARM]);
    if (since === undefined) return CLICK_POWER;
    const share = Math.min(1, (this.world.time - since) / MAX_HOLD_SECONDS);
    return CLICK_POWER + (1 - CLICK_POWER) * share;
  }

  /** Number of stars of a swarm released now; the longest hold counts. */
  get swarmStars(): number {
    let power = 0;
    for (const finger of this.held.keys()) power = Math.max(power, this.powerOf(finger, SWARM));
    return heldStars(SHELLS[SWARM], power);
  }

  /** World time at which a pointer was pressed, including inputs that the next step has yet to process. */
  #heldSince(finger: number): number | undefined {
    const { waiting } = this.log.state;
    for (let i = waiting.length - 1; i >= 0; i--) {
      const input = waiting[i];
      if ('finger' in input && input.finger === finger) return input.do === 'hold' ? this.world.time : undefined;
    }
    return this.held.get(finger);
  }

  #wholeSeconds(since = this.world.time): number {
    // Half a step absorbs the rounding of summed steps.
    const seconds = Math.floor(this.world.time - since + 0.5 * this.dt);
    return Math.min(maxHoldSeconds(SHELLS[SWARM]), seconds);
  }

  /** Hash of the state; games with equal hashes evolve equally. */
  hash(): string {
    const { held, refused, fired, showStart } = this;
    return [stateHash(this.world), this.#progress.next, showStart, refused, fired, ...held.keys()].join(' ');
  }

  #take(input: Input): void {
    if (input.do === 'hold') this.held.set(input.finger, this.world.time);
    else if (input.do === 'forget') this.held.delete(input.finger);
    else if (input.do === 'fire') this.#fire(input);
    else if (input.do === 'write') this.#write(input);
    else if (input.do === 'steer') this.#pressedKeys[input.way] = input.on;
    else if (input.do === 'play') this.#play(input.cues);
    else if (input.do === 'stop') this.#play([]);
    else if (input.do === 'wind') this.scene.setWind(input.speed);
    else this.scene.setColors(input.colors);
  }

  #fire({ finger, x, y, z, kind, color }: Extract<Input, { do: 'fire' }>): void {
    const power = this.powerOf(finger, kind);
    this.held.delete(finger);
    if (kind === SWARM && power === 0) return;
    this.fired++;
    if (this.isDemo) this.#play([]);
    this.#launch({ x, y, z, kind, color, power });
  }

  #write({ points, x, y, z, color, power }: Extract<Input, { do: 'write' }>): void {
    this.fired++;
    if (this.isDemo) this.#play([]);
    this.#launch({ points, x, y, z, kind: 0, color, power });
  }

  #play(cues: readonly Cue[]): void {
    this.isDemo = false;
    this.show = markImmutable(cues);
    this.showStart = this.world.tick;
    this.#progress.next = 0;
  }

  #moveCrosshair(): void {
    const { up, down, left, right } = this.#pressedKeys;
    if (!(up || down || left || right)) return;
    const { crosshair, dt } = this;
    const across = Number(right) - Number(left);
    const upwards = Number(up) - Number(down);
    Object.assign(
      crosshair,
      clampTo(
        FIREWORKS_SKY,
        crosshair.x + CROSSHAIR_SPEED * dt * across,
        crosshair.y + CROSSHAIR_SPEED * dt * upwards,
        0,
      ),
    );
    crosshair.isShown = true;
  }

  #playShow(): void {
    if (this.isDemo && this.world.tick - this.showStart > (this.show.at(-1)?.tick ?? 0) + DEMO_PAUSE) {
      this.showStart = this.world.tick;
      this.#progress.next = 0;
    }
    const tick = this.world.tick - this.showStart;
    while (this.isShowing && this.show[this.#progress.next].tick <= tick)
      this.#launch(this.show[this.#progress.next++]);
  }

  #launch({ x, y, z, kind, color, power, points }: ShellOrder): void {
    const random = this.#random;
    const order = {
      ...clampToSky(x, y, this.world.dimensions === 3 ? z : 0),
      kind: kind === RANDOM ? random.integer(0, RANDOM_KINDS - 1) : kind,
      color: color === RANDOM ? random.integer(0, STAR_COLORS.length - 1) : color,
      power,
      ...(points === undefined ? {} : { points }),
    };
    if (!this.scene.launch(order)) this.refused++;
  }
}

/** Clamps a point to the part of the sky that shells reach. */
export function clampToSky(x: number, y: number, z: number) {
  return clampTo(FIREWORKS_REACH, x, y, z);
}

interface Sky {
  readonly halfWidth: number;
  readonly halfDepth: number;
  readonly lowest: number;
  readonly highest: number;
}

function clampTo({ halfWidth, halfDepth, lowest, highest }: Sky, x: number, y: number, z: number) {
  const within = (value: number, low: number, high: number) => Math.min(high, Math.max(low, value));
  return { x: within(x, -halfWidth, halfWidth), y: within(y, lowest, highest), z: within(z, -halfDepth, halfDepth) };
}

export function createGame(options: FireworksOptions): FireworksGame {
  return new FireworksGame(options);
}

/** Applies a changed setting to the running game; false if the setting requires a new game. */
export function applyValue(sim: FireworksGame, name: string, values: FireworksValues): boolean {
  if (name === 'wind') sim.press({ do: 'wind', speed: values.wind });
  else if (name === 'sparks') return !values.barrage;
  else return name !== 'barrage';
  return true;
}
