/** The simulation: the scene, what players do to it, and shows. Needs no screen; seed and log give the same night. */
import { createRandom, keepState, markImmutable, stateHash } from '@principia/physics';
import {
  FIREWORKS_SKY,
  type Fireworks,
  fireworks,
  heldStars,
  InputLog,
  type LoggedInput,
  mostSeconds,
  SHELL_NAMES,
  SHELLS,
  type ShellOrder,
  STAR_COLORS,
} from '@principia/scenes';

/** A kind or colour that is drawn when the shell goes up. */
export const SURPRISE = -1;

/** The kind that is not thrown but lit where one points, after whole seconds of holding. */
export const SWARM = SHELLS.findIndex(({ isHeld }) => isHeld);
/** Kinds that a surprise is drawn from: those that a mere click sends up. */
export const THROWN = SHELL_NAMES.length - 1;

/** The ways keys push the sight. */
export type Way = 'up' | 'left' | 'down' | 'right';

/** A shell of a show: what goes up when. */
export interface Cue extends ShellOrder {
  /** When it goes up, steps after the show began. */
  readonly tick: number;
}

/** A shell as a hand orders it: kind and colour may be `SURPRISE`. */
export type Input =
  | { readonly do: 'hold'; readonly finger: number }
  | ({ readonly do: 'fire'; readonly finger: number; readonly x: number; readonly y: number; readonly z: number } & {
      readonly kind: number;
      readonly color: number;
    })
  | { readonly do: 'forget'; readonly finger: number }
  | { readonly do: 'steer'; readonly way: Way; readonly on: boolean }
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
  /** Played from the first step on. */
  readonly opening?: readonly Cue[];
  /** The opening ends as soon as somebody fires, and begins anew when it is over. */
  readonly isDemo?: boolean;
  /** Inputs of an earlier night to play again. */
  readonly log?: readonly LoggedInput<Input>[];
}

/** Shells in the air at most. */
const SHELLS_IN_AIR = 28;
/** Seconds of holding that make the largest shell, and of a mere click. */
export const LONGEST_HOLD = 1.6;
const CLICK_POWER = 0.35;

/** How fast keys push the sight, m/s. */
const SIGHT_SPEED = 30;
/** Steps from the end of the demonstration to its next beginning. */
const DEMO_PAUSE = 300;

export class FireworksGame {
  readonly scene: Fireworks;
  readonly log: InputLog<Input>;
  /** World time at which each finger began to hold. */
  readonly held = new Map<number, number>();
  /** The show that is being played. */
  show: readonly Cue[] = [];
  showStart = 0;
  /** Shells that found all mortars empty. */
  refused = 0;
  fired = 0;
  isDemo: boolean;
  /** Shells wear colours that everybody tells apart. */
  isSafe = false;
  /** Where keys aim, m; shown once a key has pushed it. */
  readonly sight = { x: 0, y: 32, z: 0, isShown: false };
  readonly #pushed: Record<Way, boolean> = { up: false, left: false, down: false, right: false };
  /** The cue that comes next. */
  readonly #progress = { next: 0 };
  readonly #random;

  constructor({ values, seed, dimensions, opening = [], isDemo = false, log }: FireworksOptions) {
    const { wind, barrage, sparks } = values;
    // Its own state is kept; the rest of it stays.
    this.scene = markImmutable(
      fireworks.create({ seed, dimensions, wind, shells: SHELLS_IN_AIR, count: barrage ? sparks : 0 }),
    );
    this.log = new InputLog(log);
    this.#random = createRandom(seed, 2);
    this.show = markImmutable(opening);
    this.isDemo = isDemo;
    keepState(this.world, this, this.#pushed, this.#progress, this.#random.state, this.log.state);
    const take = (input: Input) => this.#take(input);
    this.world.phases.input.unshift((world) => {
      this.log.take(world.tick, take);
      this.#push();
      this.#playShow();
    });
  }

  get world() {
    return this.scene.world;
  }

  get dt() {
    return this.scene.dt;
  }

  /** Whether cues of a show still wait. */
  get isShowing(): boolean {
    return this.#progress.next < this.show.length;
  }

  /** What the player does; the next step takes it. */
  press(input: Input): void {
    this.log.add(input);
  }

  /** How large a shell gets that is held since then, 0 to 1. @param kind number of the chosen kind */
  powerOf(finger: number, kind: number): number {
    const since = this.#heldSince(finger);
    if (kind === SWARM) return this.#wholeSeconds(since) / mostSeconds(SHELLS[SWARM]);
    if (since === undefined) return CLICK_POWER;
    const share = Math.min(1, (this.world.time - since) / LONGEST_HOLD);
    return CLICK_POWER + (1 - CLICK_POWER) * share;
  }

  /** Stars that a swarm would have that is let go now; what is held longest counts. */
  get swarmStars(): number {
    let most = 0;
    for (const finger of this.held.keys()) most = Math.max(most, this.powerOf(finger, SWARM));
    return heldStars(SHELLS[SWARM], most);
  }

  /** World time at which a finger began to hold, also where the next step is yet to take what it did last. */
  #heldSince(finger: number): number | undefined {
    const { waiting } = this.log.state;
    for (let i = waiting.length - 1; i >= 0; i--) {
      const input = waiting[i];
      if ('finger' in input && input.finger === finger) return input.do === 'hold' ? this.world.time : undefined;
    }
    return this.held.get(finger);
  }

  #wholeSeconds(since = this.world.time): number {
    // Half a step more: times are sums of steps.
    const seconds = Math.floor(this.world.time - since + 0.5 * this.dt);
    return Math.min(mostSeconds(SHELLS[SWARM]), seconds);
  }

  /** Two games with equal hashes go on alike. */
  hash(): string {
    const { held, refused, fired, showStart } = this;
    return [stateHash(this.world), this.#progress.next, showStart, refused, fired, ...held.keys()].join(' ');
  }

  #take(input: Input): void {
    if (input.do === 'hold') this.held.set(input.finger, this.world.time);
    else if (input.do === 'forget') this.held.delete(input.finger);
    else if (input.do === 'fire') this.#fire(input);
    else if (input.do === 'steer') this.#pushed[input.way] = input.on;
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

  #play(cues: readonly Cue[]): void {
    this.isDemo = false;
    this.show = markImmutable(cues);
    this.showStart = this.world.tick;
    this.#progress.next = 0;
  }

  #push(): void {
    const { up, down, left, right } = this.#pushed;
    if (!(up || down || left || right)) return;
    const { sight, dt } = this;
    const across = Number(right) - Number(left);
    const upwards = Number(up) - Number(down);
    Object.assign(sight, clampToSky(sight.x + SIGHT_SPEED * dt * across, sight.y + SIGHT_SPEED * dt * upwards, 0));
    sight.isShown = true;
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

  #launch({ x, y, z, kind, color, power }: ShellOrder): void {
    const random = this.#random;
    const order = {
      ...clampToSky(x, y, this.world.dimensions === 3 ? z : 0),
      kind: kind === SURPRISE ? random.integer(0, THROWN - 1) : kind,
      color: color === SURPRISE ? random.integer(0, STAR_COLORS.length - 1) : color,
      power,
    };
    if (!this.scene.launch(order)) this.refused++;
  }
}

/** The place in the part of the sky that shells reach which is nearest. */
export function clampToSky(x: number, y: number, z: number) {
  const { halfWidth, halfDepth, lowest, highest } = FIREWORKS_SKY;
  const within = (value: number, low: number, high: number) => Math.min(high, Math.max(low, value));
  return { x: within(x, -halfWidth, halfWidth), y: within(y, lowest, highest), z: within(z, -halfDepth, halfDepth) };
}

export function createGame(options: FireworksOptions): FireworksGame {
  return new FireworksGame(options);
}

/** Gives the running game a changed setting; false where only a new one can have it. */
export function applyValue(sim: FireworksGame, name: string, values: FireworksValues): boolean {
  if (name === 'wind') sim.press({ do: 'wind', speed: values.wind });
  else if (name === 'sparks') return !values.barrage;
  else return name !== 'barrage';
  return true;
}
