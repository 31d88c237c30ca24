import { bodies, energy, stateHash } from '@principia/physics';
import type { Simulation, View } from './game.ts';
import type { Session } from './session.ts';
import type { Settings } from './settings.ts';

/** A body for tests: SI units, and its position on the canvas in CSS pixels. */
export interface BodyState {
  /** Entity id. */
  readonly id: number;
  /** Position, m. */
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Velocity, m/s. */
  readonly vx: number;
  readonly vy: number;
  readonly vz: number;
  /** Radius of the collider, m. */
  readonly radius: number;
  /** Where it is on the canvas, CSS pixels; undefined without a view. */
  readonly screen: { readonly x: number; readonly y: number } | undefined;
}

/** The result of `__game.state()`. */
export interface GameState {
  /** Whether the view and the sidebar are ready. */
  readonly ready: boolean;
  /** Name of the renderer, as in the address. */
  readonly renderer: string;
  /** Whether the game is paused. */
  readonly paused: boolean;
  /** Simulated seconds per real second. */
  readonly speed: number;
  /** Simulated seconds that can be rewound. */
  readonly historySeconds: number;
  /** Whether recorded moments lie ahead. */
  readonly isPast: boolean;
  /** Whether the player rewound this game, or watches a replay. */
  readonly rewound: boolean;
  /** Whether motion is reduced, by the player or by the system. */
  readonly reducedMotion: boolean;
  /** Whether the player asked for the colour-blind palette. */
  readonly safeColors: boolean;
  /** Whether a video is being recorded. */
  readonly recording: boolean;
  /** Seed of the world. */
  readonly seed: number;
  /** A copy of the settings. */
  readonly values: Readonly<Record<string, unknown>>;
  /** Time of the world, s. */
  readonly time: number;
  /** Steps of the world. */
  readonly tick: number;
  /** Number of bodies. */
  readonly count: number;
  /** Contacts between bodies in the last step; undefined where the game does not count them. */
  readonly contacts: number | undefined;
  /** Ids of the bodies that pointers drag. */
  readonly dragged: readonly number[];
  /** `stateHash` of the world. */
  readonly hash: string;
  /** Energies of the world, J unless it has units of its own. */
  readonly energy: { readonly kinetic: number; readonly potential: number; readonly total: number };
  /** What the reader's plot shows, as the address names it; undefined while there is no plot. */
  readonly plot: string | undefined;
  /** Text of the banner; empty when it is hidden. */
  readonly banner: string;
  /** Milliseconds per frame, per step, and per submission of the world to the renderer. */
  readonly timing: { readonly frame: number; readonly step: number; readonly draw: number };
  /** Values that the game reports, such as lives and score. */
  readonly game: Readonly<Record<string, unknown>>;
}

/** `globalThis.__game`: the interface for tests and for the browser's console. */
export interface GameHook {
  /** Names of the game's renderers. */
  readonly renderers: readonly string[];
  /** The present state, in a new object. */
  state(): GameState;
  /** Body number `index`, from 0, in ascending order of ids. @throws Error if there is none */
  body(index: number): BodyState;
  /** Takes `count` steps at once; plots and cards record each of them, as far as `GameDefinition.plotInterval` lets them. */
  step(count?: number): void;
  /** Rewinds by `seconds` of simulated time, to a snapshot. */
  rewind(seconds: number): void;
  /** Goes to the last recorded moment not after a time, s. */
  seek(time: number): void;
  /** Makes a new world; `seed` default the present one. */
  reset(seed?: number): void;
  /** Changes a setting, and makes a new world where it needs one. @throws Error if there is no such setting or value */
  set(name: string, value: unknown): void;
  /** Pauses the game. */
  pause(): void;
  /** Lets it go on. */
  resume(): void;
  /** Resolves when the view of the other renderer is open. */
  show(renderer: string): Promise<void>;
}

declare global {
  var __game: GameHook;
}

/** The body at an index of the ascending list of bodies. */
function bodyState<S extends Settings, Sim extends Simulation>(
  session: Session<S, Sim>,
  view: View | undefined,
  index: number,
): BodyState {
  const { world } = session.sim;
  const list = bodies(world);
  if (!(index >= 0 && index < list.count))
    throw new Error(`There is no body at index ${index}: the index must be from 0 to ${list.count - 1}.`);
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

/** What the page around a session is like. */
export interface PageState
  extends Pick<GameState, 'ready' | 'renderer' | 'reducedMotion' | 'recording' | 'plot' | 'banner' | 'timing'> {
  readonly view: View | undefined;
}

/** Makes a hook that of the page until the signal. */
export function offerHook(hook: GameHook, signal: AbortSignal): void {
  globalThis.__game = hook;
  signal.addEventListener('abort', () => {
    if (globalThis.__game === hook) Reflect.deleteProperty(globalThis, '__game');
  });
}

/** @param restore moves the session to a moment of the past @param record lets cards record a step */
export function createHook<S extends Settings, Sim extends Simulation>(
  session: Session<S, Sim>,
  page: () => PageState,
  restore: (move: () => boolean) => void,
  record: () => void,
  actions: Pick<GameHook, 'reset' | 'set' | 'pause' | 'resume' | 'show'>,
): GameHook {
  return {
    renderers: Object.keys(session.game.renderers),
    state() {
      const { view: _, ...shown } = page();
      return { ...sessionState(session), ...shown, game: session.game.report?.(session.sim) ?? {} };
    },
    body: (index) => bodyState(session, page().view, index),
    step(count = 1) {
      // There may have been no frame since the world was made.
      if (count > 0) record();
      for (let i = 0; i < count; i++) {
        session.step();
        record();
      }
    },
    rewind: (seconds) => restore(() => session.rewind(seconds)),
    seek: (time) => restore(() => session.seek(time)),
    ...actions,
  };
}

/** The part of the state that the session provides. */
function sessionState<S extends Settings, Sim extends Simulation>(session: Session<S, Sim>) {
  const { sim, paused, speed, historySeconds, isPast, rewound, safeColors, seed, values, dragging } = session;
  const { world } = sim;
  return {
    paused,
    speed,
    historySeconds,
    isPast,
    rewound,
    safeColors,
    seed,
    values: { ...values },
    dragged: dragging.dragged,
    time: world.time,
    tick: world.tick,
    count: bodies(world).count,
    contacts: session.game.contacts?.(sim),
    hash: stateHash(world),
    energy: energy(world),
  };
}
