import { bodies, energy, stateHash } from '@principia/physics';
import type { Simulation, View } from './game.ts';
import type { Session } from './session.ts';
import type { Settings } from './settings.ts';

/** A body as tests see it: SI units, and its place on the canvas in CSS pixels. */
export interface BodyState {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly vx: number;
  readonly vy: number;
  readonly vz: number;
  readonly radius: number;
  readonly screen: { readonly x: number; readonly y: number } | undefined;
}

/** What `__game.state()` tells. */
export interface GameState {
  /** Whether there is a picture, and all that stands beside it. */
  readonly ready: boolean;
  readonly renderer: string;
  readonly paused: boolean;
  /** Simulated seconds a real second. */
  readonly speed: number;
  /** Simulated seconds that the player can go back, and whether he did. */
  readonly past: number;
  readonly rewound: boolean;
  readonly calm: boolean;
  readonly safeColors: boolean;
  readonly filming: boolean;
  readonly seed: number;
  readonly values: Readonly<Record<string, unknown>>;
  readonly time: number;
  readonly tick: number;
  readonly count: number;
  readonly contacts: number | undefined;
  readonly held: readonly number[];
  readonly hash: string;
  readonly energy: { readonly kinetic: number; readonly potential: number; readonly total: number };
  /** What the banner says; empty when it is hidden. */
  readonly banner: string;
  /** Milliseconds: from picture to picture, a step, handing the world to the renderer. */
  readonly timing: { readonly frame: number; readonly step: number; readonly draw: number };
  /** What the game itself tells: lives, score. */
  readonly game: Readonly<Record<string, unknown>>;
}

/** `globalThis.__game`: how tests, and curious people in the console, work a game. */
export interface GameHook {
  /** Names of the game's renderers. */
  readonly renderers: readonly string[];
  state(): GameState;
  /** Body number `index` in ascending order of ids. */
  body(index: number): BodyState;
  /** `count` steps at once. */
  step(count?: number): void;
  /** Goes back by `seconds` of simulated time, to a moment that was kept. */
  rewind(seconds: number): void;
  reset(seed?: number): void;
  set(name: string, value: unknown): void;
  pause(): void;
  resume(): void;
  /** Resolves when the other picture is there. */
  show(renderer: string): Promise<void>;
}

declare global {
  var __game: GameHook;
}

/** The body at a place of the ascending list of bodies. */
export function bodyState<S extends Settings, Sim extends Simulation>(
  session: Session<S, Sim>,
  view: View | undefined,
  index: number,
): BodyState {
  const { world } = session.sim;
  const list = bodies(world);
  if (!(index >= 0 && index < list.count)) throw new Error(`There are ${list.count} bodies, and none at ${index}.`);
  const id = list.ids[index];
  const { Position, Velocity, Collider } = world.components;
  const [x, y, z] = [Position.x[id], Position.y[id], Position.z[id]];
  return {
    id,
    x,
    y,
    z,
    vx: Velocity.x[id],
    vy: Velocity.y[id],
    vz: Velocity.z[id],
    radius: Collider.radius[id],
    screen: view?.toScreen(x, y, z),
  };
}

/** The part of the state that the session knows. */
export function sessionState<S extends Settings, Sim extends Simulation>(session: Session<S, Sim>) {
  const { sim, paused, speed, past, rewound, safeColors, seed, values, holding } = session;
  const { world } = sim;
  return {
    paused,
    speed,
    past,
    rewound,
    safeColors,
    seed,
    values: { ...values },
    held: holding.held,
    time: world.time,
    tick: world.tick,
    count: bodies(world).count,
    contacts: session.game.contacts?.(sim),
    hash: stateHash(world),
    energy: energy(world),
  };
}
