/** The interfaces between a game, the shell and the views. */
import type { PhysicsWorld } from '@principia/physics';
import type { ClipControl } from './clip-button.ts';
import type { Controls } from './controls.ts';
import type { Dragging, DragOptions } from './dragging.ts';
import type { Outcome } from './outcome-card.ts';
import type { OwnUnits } from './plot-sources.ts';
import type { Settings, ValuesOf } from './settings.ts';

/** A world and its time step; a `SceneRun` of the scenes package is a `Simulation`. */
export interface Simulation {
  /** The shell steps and, when it is replaced, destroys it. */
  readonly world: PhysicsWorld;
  /** Length of every step, s. */
  readonly dt: number;
}

/** The parameters of a new world. */
export interface SimulationOptions<S extends Settings> {
  /** A copy of the player's settings. */
  readonly values: ValuesOf<S>;
  /** The same seed shall give the same world. */
  readonly seed: number;
  /** Those of the renderer that is shown. */
  readonly dimensions: 2 | 3;
}

/** Margins of the stage that the toolbar and the sidebar cover, CSS pixels. */
export interface Insets {
  /** Of the toolbar. */
  readonly top: number;
  /** Of the sidebar, if it stands beside the stage. */
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** The services that the shell offers to a view. */
export interface ViewContext<S extends Settings, Sim extends Simulation> {
  /** The view appends its canvas to this element, which fills the window or the element of the game. */
  readonly element: HTMLElement;
  /** What the toolbar, the sidebar and the timeline cover now. The object is used again. */
  readonly insets: () => Insets;
  /** The world on display; replaced by every reset. */
  readonly sim: () => Sim;
  /** The present settings. */
  readonly values: () => Readonly<ValuesOf<S>>;
  /** Toggles a switch of the game, as its key does. */
  readonly toggle: (setting: keyof S & string) => void;
  /** Position of the picture between the last two steps, 0 to 1. */
  readonly alpha: () => number;
  /** The bodies that pointers drag. */
  readonly dragging: () => Dragging;
  /** Whether the space bar is held: a drag then moves the view. */
  readonly isSpaceHeld: () => boolean;
  /** The player asked for reduced motion; the view is refreshed when this changes. */
  readonly reducedMotion: boolean;
  /** The player asked for a colour-blind palette, such as `SAFE_COLORS`; the view is refreshed when this changes. */
  readonly safeColors: boolean;
  /** Shows a sentence until the player hides it or another message replaces it. */
  readonly showMessage: (sentence: string) => void;
  /** Clips of the play that follows; `createClipButton` makes a button of it. */
  readonly clip: ClipControl;
}

/** A view draws a simulation. */
export interface View {
  /** What is drawn to: what gets the focus, is photographed and filmed. */
  readonly canvas: HTMLCanvasElement;
  /** Called when the world was replaced or the appearance changed (`world`), or when a setting changed. */
  refresh(change: 'world' | 'setting'): void;
  /** Draws a frame. @param seconds since the previous frame */
  draw(alpha: number, seconds: number): void;
  /** Fits the whole scene into the window. */
  fit(): void;
  /** Zooms about the centre: in for a factor above one, out below. */
  zoom(factor: number): void;
  /** Numbers that describe what is seen, for addresses. In 2D: centre and height of the window, m. */
  camera?(): readonly number[];
  /** Shows what `camera` described. */
  setCamera?(numbers: readonly number[]): void;
  /** Position of a world point on the canvas, CSS pixels. */
  toScreen(x: number, y: number, z: number): { x: number; y: number };
  /** Ends what the view began: listeners, textures, the canvas with its graphics context. */
  destroy(): void;
}

/** A renderer of a game. */
export interface Renderer<S extends Settings, Sim extends Simulation> {
  /** Label on the switch, such as `2D`. */
  readonly label: string;
  /** Dimensions of the worlds that it draws: `create` gets them. */
  readonly dimensions: 2 | 3;
  /**
   * Creates the view. The renderer is imported here so that a page loads only the renderers that it shows. What it throws is shown
   * to the player as a sentence, with a button to try again.
   */
  open(context: ViewContext<S, Sim>): Promise<View>;
}

/** A quantity of a game's own, which its plot offers. */
export interface GameQuantity<Sim extends Simulation> {
  /** Shown in the lists of the plot, and in the CSV. */
  readonly label: string;
  /** Such as `K` or `m/s`; empty for a pure number. */
  readonly unit: string;
  /** The present value; not a number where there is none yet. */
  value(sim: Sim): number;
}

/** A card of a game's own in the sidebar. */
export interface GameCard<Sim extends Simulation> {
  /**
   * Called after the steps of each frame, and with a new world at once.
   * @param isPast the world was moved back to a moment after which others are recorded, and has not stepped on
   */
  record?(sim: Sim, isPast: boolean): void;
  /** Brings the card up to date; called five times a second. */
  show(sim: Sim): void;
  /** Ends what outlives the card's elements, such as timers, when the game is stopped. */
  destroy?(): void;
}

/**
 * A line of the help: keys or gestures and what they do; then the gesture on a touch screen, empty where it needs no such line, and
 * what that does, where they differ.
 */
export type HelpLine = readonly [input: string, description: string, gesture?: string, gestureDescription?: string];

/** The definition of a game. */
export interface GameDefinition<S extends Settings, Sim extends Simulation> {
  /** The name, in the toolbar and in the names of files. */
  readonly title: string;
  /** Name under which the browser keeps scores; default the title. A game of several languages has one for all. */
  readonly scoresName?: string;
  /** On phones the sidebar is a sheet below or beside the picture, open at the start; default false. */
  readonly hasSheet?: boolean;
  /** The settings by name, in the order of the panel. */
  readonly settings: S;
  /** Renderers by name as in `?renderer=`; the first is the default. */
  readonly renderers: Readonly<Record<string, Renderer<S, Sim>>>;
  /**
   * Creates a simulation. State kept outside the world's columns must be registered with `keepState`, so that rewinding
   * works.
   */
  create(options: SimulationOptions<S>): Sim;
  /** Applies a changed setting to the running world; false asks for a new world instead. */
  apply(sim: Sim, name: keyof S & string, values: Readonly<ValuesOf<S>>): boolean;
  /** Assigns colours to bodies: in a new world, and when the player changes the palette. */
  applyColors?(sim: Sim, options: { readonly seed: number; readonly safeColors: boolean }): void;
  /** How pointers drag bodies; default `dragBodies`. A game of rigid bodies gives `dragByJoints`. */
  readonly drag?: (world: PhysicsWorld, options: DragOptions) => Dragging;
  /** Changes the target position of a dragged body in place, for example to keep it inside a box. */
  dragLimit?(sim: Sim): DragOptions['limit'];
  /** Largest speed of a dragged or thrown body, m/s; default 50. */
  dragSpeed?(sim: Sim): number;
  /** Creates the same game from its beginning and replays the player's inputs. */
  replay?(sim: Sim): Sim;
  /** Number of contacts between bodies in the last step; undefined while the world does not count them. */
  contacts?(sim: Sim): number | undefined;
  /** The controls of the game. Default none. */
  readonly controls?: Controls<Sim>;
  /** The result of the game, for the card with the high scores; undefined while the game is running. */
  outcome?(sim: Sim): Outcome | undefined;
  /**
   * Number of attempts that began in this world, for a game whose player begins anew in the same world: a result is ranked unless the
   * player rewound in its attempt. It must not go back when the world does. Default one attempt for each world.
   */
  attempt?(sim: Sim): number;
  /** Values such as lives and score, for tests: `__game.state().game`. */
  report?(sim: Sim): Readonly<Record<string, unknown>>;
  /**
   * Quantities of the game's own for the plot and its CSV, by their names in the address, `?plot=temperature`: letters and
   * digits that begin with a small letter. Default none.
   */
  readonly quantities?: Readonly<Record<string, GameQuantity<Sim>>>;
  /**
   * Time between two rows of the plot and its CSV, s, rounded to whole steps. Default each step has one, 12 s of them (40 s of one
   * quantity against another), at most 24 000; where reading the values would take more than a twentieth of the time, as the energy of a galaxy
   * does, they are further apart by themselves, at most 0.05 s or one step. The plot then says how far.
   */
  plotInterval?(sim: Sim): number;
  /** Creates the game's own cards in the sidebar, below the settings; it is called after the first frame. */
  cards?(parent: HTMLElement): Promise<readonly GameCard<Sim>[]>;
  /**
   * Address of what is on display. Default: that of its settings, its seed, its renderer and its plot; and a page that the game has to
   * itself keeps changed settings in its address.
   */
  link?(): string;
  /** Whether time stands still although the game is not paused: at the end of a run, or while the player holds it. */
  hasEnded?(sim: Sim): boolean;
  /** Shows a bar below the picture on which the player moves through what was recorded; default false. */
  readonly hasTimeline?: boolean;
  /** Simulated seconds that can be rewound, where memory allows; default 20. */
  rewindSeconds?(sim: Sim): number;
  /** Units of a world that is not in SI, by the SI units that plots show otherwise: `{ m: 'km' }`. Default none. */
  readonly units?: OwnUnits;
  /** Number of bodies in the statistics; default all of the world. A game with a pool of bodies counts those in use. */
  bodies?(sim: Sim): number;
  /** Lines of the help, above those of the shell. Default none. */
  readonly help?: readonly HelpLine[];
  /** Whether each load of the page begins with another seed, unless the address has one; default false. */
  readonly variesSeed?: boolean;
  /** Address of the page with all games, for the link in the toolbar; default none. */
  readonly home?: string;
}
