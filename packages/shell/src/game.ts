/** What a game tells the shell about itself, and what the shell hands to its views. */
import type { PhysicsWorld } from '@principia/physics';
import type { Controls } from './controls.ts';
import type { Holding, HoldingOptions } from './holding.ts';
import type { Outcome } from './outcome-card.ts';
import type { Settings, ValuesOf } from './settings.ts';

/** A world and how it moves; a `SceneRun` of the scenes package is one. */
export interface Simulation {
  readonly world: PhysicsWorld;
  /** Length of every step, s. */
  readonly dt: number;
}

/** What a world is made from. */
export interface SimulationOptions<S extends Settings> {
  readonly values: ValuesOf<S>;
  readonly seed: number;
  readonly dimensions: 2 | 3;
}

/** Room along the edges of the stage that lies under the bar and the panel, CSS pixels. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** Where a view draws, and what it may ask for. */
export interface Stage<S extends Settings, Sim extends Simulation> {
  /** The view appends its canvas to this element, which fills the window. */
  readonly element: HTMLElement;
  readonly insets: () => Insets;
  /** The world shown now; another one after every reset. */
  readonly sim: () => Sim;
  readonly values: () => Readonly<ValuesOf<S>>;
  /** Turns one of the game's switches, as its key does. */
  readonly toggle: (setting: keyof S & string) => void;
  /** Where between the last two steps the picture is, 0 to 1. */
  readonly alpha: () => number;
  /** Bodies that pointers hold. */
  readonly holding: () => Holding;
  /** The player wants as little motion as possible; the view is refreshed when that changes. */
  readonly reducedMotion: boolean;
  /** The player wants colours that everybody tells apart, such as `SAFE_COLORS`; likewise. */
  readonly safeColors: boolean;
  /** Shows a sentence that the player should know, until it is hidden or another one comes. */
  readonly say: (sentence: string) => void;
}

/** A picture of a simulation. */
export interface View {
  readonly canvas: HTMLCanvasElement;
  /** The world was replaced, or everything looks different (`world`), or a setting changed. */
  refresh(change: 'world' | 'setting'): void;
  /** Draws once. @param seconds since the last time */
  draw(alpha: number, seconds: number): void;
  /** Shows everything. */
  fit(): void;
  /** Closer (above one) or farther, about the middle. */
  zoom(factor: number): void;
  /** The place of a world point on the canvas, CSS pixels. */
  toScreen(x: number, y: number, z: number): { x: number; y: number };
  destroy(): void;
}

/** A way to draw a game. */
export interface Renderer<S extends Settings, Sim extends Simulation> {
  /** What the switch calls it, such as `2D`. */
  readonly label: string;
  readonly dimensions: 2 | 3;
  /** Makes the view; imports the renderer only now, so that a page loads no more than it shows. */
  open(stage: Stage<S, Sim>): Promise<View>;
}

/** A game. */
export interface GameDefinition<S extends Settings, Sim extends Simulation> {
  readonly title: string;
  readonly settings: S;
  /** By name as in `?renderer=`; the first is the default. */
  readonly renderers: Readonly<Record<string, Renderer<S, Sim>>>;
  /** What the game keeps outside the world's columns is to be named to `keepState`, for those who go back in time. */
  create(options: SimulationOptions<S>): Sim;
  /** Gives the running world a changed setting; false asks for a new world instead. */
  apply(sim: Sim, name: keyof S & string, values: Readonly<ValuesOf<S>>): boolean;
  /** Gives bodies their colours: in a new world, and when the player wants other colours. */
  dress?(sim: Sim, looks: { readonly seed: number; readonly safeColors: boolean }): void;
  /** How a held body's wanted place is changed, in place, as to keep it inside a room. */
  holdLimit?(sim: Sim): HoldingOptions['limit'];
  /** The same game from its beginning, played again from what the player did in it. */
  replay?(sim: Sim): Sim;
  /** Contacts between bodies in the last step; undefined while the world has none to count. */
  contacts?(sim: Sim): number | undefined;
  /** How the player steers. */
  readonly controls?: Controls<Sim>;
  /** How the game ended, for the card with the high scores; undefined while it goes on. */
  outcome?(sim: Sim): Outcome | undefined;
  /** Lives, score and the like, for tests: `__game.state().game`. */
  tell?(sim: Sim): Readonly<Record<string, unknown>>;
  /** Lines for the help: keys or gestures, and what they do. */
  readonly help?: readonly (readonly [string, string])[];
}
