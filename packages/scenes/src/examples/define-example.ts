import { type Integrator, PhysicsError } from '@principia/physics';
import { checkParameter, type SceneRun } from '../scene.ts';
import { type Check, type CheckState, type Monitor, monitor } from './check.ts';
import { densities } from './densities.ts';
import { type Figures, figuresOf } from './figures.ts';
import type { Picture, Point } from './picture.ts';
import { type Plot, type PlotOf, plotOf } from './plot.ts';

/** A parameter of an example: a number in a range, or a choice of words, whose value is the index of the word. */
export interface ExampleParameter {
  readonly label: string;
  /** SI unit, or the unit of the book with its scale; left out for a dimensionless number. */
  readonly unit?: string;
  /** The default value. */
  readonly initial: number;
  readonly min: number;
  readonly max: number;
  readonly integer?: boolean;
  /** A logarithmic slider, for a range of several powers of ten; `min` is then positive. */
  readonly scale?: 'log';
  /** One line. */
  readonly about?: string;
  /** Words instead of numbers, from index `min` = 0 to `max`; see `choiceOf`. */
  readonly choices?: readonly string[];
}

/** A parameter that is a choice of words. @param initial index of the word to begin with */
export function choiceOf(label: string, choices: readonly string[], initial = 0): ExampleParameter {
  return { label, initial, min: 0, max: choices.length - 1, integer: true, choices };
}

/** The values of the parameters, by name. */
export type ValuesOf<Name extends string> = Readonly<Record<Name, number>>;

/** What `build` gets besides the values. */
export interface BuildOptions {
  /** Equal seeds and values give equal worlds. */
  readonly seed: number;
  /** Replaces the integrator of the example, to compare schemes. */
  readonly integrator?: Integrator;
}

/** A distribution: how many of some numbers are in each of equal intervals, as a density. */
export interface Histogram<Run, Values> {
  readonly title: string;
  /** Label and unit of the numbers, and the range that is divided into intervals; numbers beyond it are not shown. */
  readonly x: { readonly label: string; readonly min: number; readonly max: number };
  readonly intervals: number;
  /** The present numbers, such as the speeds of all molecules. */
  readonly samples: (run: Run) => ArrayLike<number>;
  /** The exact density at x, per unit of x, drawn as a thin line. */
  readonly exact?: (x: number, time: number, values: Values) => number;
}

/** Named values of the parameters, such as another launch velocity. */
export interface ExamplePreset<Name extends string> {
  readonly label: string;
  readonly values: Partial<ValuesOf<Name>>;
}

/** What the player can do besides changing parameters: a key, and a button where there is no keyboard. */
export interface ExampleAction<Run> {
  /** A symbol or a short word for the button. */
  readonly label: string;
  /** What happens, such as `fire the main engine`. */
  readonly about: string;
  /** Value of `KeyboardEvent.key` in lower case, such as `arrowup` or `c`. */
  readonly key: string;
  press(run: Run): void;
  /** Called when the key is released, for what acts as long as it is held. */
  release?(run: Run): void;
}

/**
 * What a press on the picture does where no body is. Places are in the units of the world; in three dimensions they are
 * in the plane through the middle of the view that faces the camera, and a drag turns the view instead: only a press
 * that stays counts.
 */
export interface ExamplePointer<Run> {
  /** What happens, such as `place a planet, and launch it by a drag`. */
  readonly about: string;
  /** Draws a line from the place of the press to the pointer. */
  readonly aims?: boolean;
  press?(run: Run, at: Point): void;
  move?(run: Run, at: Point, from: Point): void;
  /** @param from the place of the press */
  release?(run: Run, at: Point, from: Point): void;
  /** Called instead of `release` where a second finger or the system takes the press back. */
  cancel?(run: Run): void;
}

/** What happens to a press on the picture. */
export type PointerEventName = 'press' | 'move' | 'release' | 'cancel';

/** A list that is made from what makes its items. */
type Made<Makers, Item> = (makers: NoInfer<Makers>) => readonly NoInfer<Item>[];

function listBy<Makers, Item>(list: readonly Item[] | Made<Makers, Item>, makers: NoInfer<Makers>): readonly Item[] {
  return typeof list === 'function' ? list(makers) : list;
}

/** The definition of an example. */
export interface ExampleSpec<Name extends string, Run extends SceneRun> {
  /** Chapter and name, as the path of the file: `ch05-floating-ball` is in `ch05/floating-ball.ts`. */
  readonly id: string;
  readonly title: string;
  readonly chapter: number;
  readonly tags: readonly string[];
  /** What one sees and which law is behind it; a few sentences. */
  readonly about: string;
  /** The world has three dimensions. */
  readonly dimensions?: 2 | 3;
  /** How long it takes until everything has been seen and checked, s. */
  readonly duration: number;
  /** The run stops at the end of its duration; left out, it goes on. */
  readonly ends?: boolean;
  /** The energy of the world stays the same with all values of the parameters, which a test tries; left out, it may change. */
  readonly conservesEnergy?: boolean;
  readonly parameters: Readonly<Record<Name, ExampleParameter>>;
  readonly presets?: readonly ExamplePreset<Name>[];
  /** Builds the world. The result also names the bodies that picture, plots and checks refer to. */
  build(values: ValuesOf<Name>, options: BuildOptions): Run;
  picture(run: Run, values: ValuesOf<Name>): Picture;
  /** By name; the names `up`, `down`, `left`, `right` and `action` give their place on the touch pad. */
  readonly actions?: Readonly<Record<string, ExampleAction<NoInfer<Run>>>>;
  /** What a press on the picture does where no body is: the name of an action, or something that depends on the place. */
  readonly pointer?: string | ExamplePointer<NoInfer<Run>>;
  /** A list, or a function of what makes plots against the time. */
  readonly plots: readonly Plot<Run, ValuesOf<Name>>[] | Made<PlotOf<Run, ValuesOf<Name>>, Plot<Run, ValuesOf<Name>>>;
  readonly histograms?: readonly Histogram<Run, ValuesOf<Name>>[];
  /** A list, or a function of what makes figures of the usual kinds. */
  readonly checks:
    | readonly Check<Run, ValuesOf<Name>>[]
    | Made<Figures<Run, ValuesOf<Name>>, Check<Run, ValuesOf<Name>>>;
  /** Sentences that tell the reader what to change and what to watch. */
  readonly tryThis: readonly string[];
}

/** Options of a run; parameters that are left out have their default values. */
export interface ExampleOptions {
  readonly values?: Readonly<Record<string, number>>;
  readonly seed?: number;
  readonly integrator?: Integrator;
}

/** A run of an example: the world, what to show, and the state of its checks. */
export interface ExampleRun extends SceneRun {
  readonly picture: Picture;
  readonly values: Readonly<Record<string, number>>;
  /** The integrator that the example has by default. */
  readonly ownIntegrator: Integrator;
  readonly plots: readonly LivePlot[];
  readonly histograms: readonly LiveHistogram[];
  /** Presses or releases the key of an action. */
  act(name: string, isDown: boolean): void;
  /** Passes on what happens to a press on the picture. @param from the place of the press */
  point(name: PointerEventName, at: Point, from: Point): void;
  /** Measures the present state for the checks; without it a check is one step late. */
  observe(): void;
  checkStates(): readonly CheckState[];
  /** Whether no check is waiting. */
  isDone(): boolean;
}

/** A plot of a run. */
export interface LivePlot {
  readonly title: string;
  readonly x: { readonly label: string; readonly value: () => number };
  readonly y: { readonly label: string };
  readonly series: readonly {
    readonly label: string;
    readonly value: () => number;
    readonly exact?: (time: number) => number;
  }[];
}

/** A histogram of a run. */
export interface LiveHistogram {
  readonly title: string;
  readonly x: { readonly label: string; readonly min: number; readonly max: number };
  /** The present density in each interval, per unit of x. */
  readonly densities: () => Float64Array;
  /** The exact density at x now, if it is known. */
  readonly exact?: (x: number) => number;
}

/** An example: its description, and `start`. */
export interface Example {
  readonly id: string;
  readonly title: string;
  readonly chapter: number;
  readonly tags: readonly string[];
  readonly about: string;
  readonly dimensions: 2 | 3;
  readonly duration: number;
  readonly ends: boolean;
  readonly conservesEnergy: boolean;
  readonly parameters: Readonly<Record<string, ExampleParameter>>;
  readonly presets: readonly ExamplePreset<string>[];
  readonly actions: Readonly<Record<string, Pick<ExampleAction<never>, 'label' | 'about' | 'key'>>>;
  readonly pointer?: Pick<ExamplePointer<never>, 'about' | 'aims'>;
  readonly tryThis: readonly string[];
  readonly checks: readonly Pick<Check<never, never>, 'label' | 'unit' | 'tolerance' | 'integrator' | 'preset'>[];
  /** Builds a run. @throws PhysicsError E_UNKNOWN, E_TYPE, E_NONFINITE, E_RANGE for invalid values */
  start(options?: ExampleOptions): ExampleRun;
}

/** Makes an example from its definition. */
export function defineExample<Name extends string, Run extends SceneRun>(spec: ExampleSpec<Name, Run>): Example {
  const { id, title, chapter, tags, about, dimensions = 2, duration, ends = false, conservesEnergy = false } = spec;
  const { parameters, presets = [], actions = {}, tryThis } = spec;
  const parts = partsOf(spec);
  const { checks, pointer } = parts;
  return {
    id,
    title,
    chapter,
    tags,
    about,
    dimensions,
    duration,
    ends,
    conservesEnergy,
    parameters,
    presets,
    actions,
    ...(pointer === undefined ? {} : { pointer }),
    tryThis,
    checks,
    start(options = {}) {
      const values = completeValues(spec.id, parameters, options.values ?? {});
      return startRun(spec, parts, values as ValuesOf<Name>, options);
    },
  };
}

/** What is the same in all runs. */
interface Parts<Run, Values> {
  readonly plots: readonly Plot<Run, Values>[];
  readonly checks: readonly Check<Run, Values>[];
  readonly pointer: ExamplePointer<Run> | undefined;
}

function partsOf<Name extends string, Run extends SceneRun>(spec: ExampleSpec<Name, Run>): Parts<Run, ValuesOf<Name>> {
  return {
    plots: listBy(spec.plots, plotOf()),
    checks: listBy(spec.checks, figuresOf()),
    pointer: pointerOf(spec),
  };
}

/** @throws PhysicsError E_UNKNOWN if it names an action that does not exist */
function pointerOf<Name extends string, Run extends SceneRun>(
  spec: ExampleSpec<Name, Run>,
): ExamplePointer<Run> | undefined {
  const { id, pointer, actions = {} } = spec;
  if (typeof pointer !== 'string') return pointer;
  const action = actions[pointer];
  if (action === undefined) {
    throw new PhysicsError('E_UNKNOWN', `the example ${id} has no action "${pointer}" for its pointer.`, {
      field: 'pointer',
      hint: `Valid: ${Object.keys(actions).join(', ')}.`,
    });
  }
  const release = (run: Run) => action.release?.(run);
  return { about: action.about, press: (run) => action.press(run), release, cancel: release };
}

function startRun<Name extends string, Run extends SceneRun>(
  spec: ExampleSpec<Name, Run>,
  { plots, checks, pointer }: Parts<Run, ValuesOf<Name>>,
  values: ValuesOf<Name>,
  { seed = 1, integrator }: ExampleOptions,
): ExampleRun {
  const run = spec.build(values, { seed, ...(integrator === undefined ? {} : { integrator }) });
  const { world, dt } = run;
  const ownIntegrator = integrator === undefined ? world.integrator : spec.build(values, { seed }).world.integrator;
  if (integrator !== undefined) world.integrator = integrator;
  const hasValuesOf = (label?: string) => {
    const preset: Partial<ValuesOf<Name>> = spec.presets?.find((each) => each.label === label)?.values ?? {};
    return Object.entries<ExampleParameter>(spec.parameters).every(
      ([name, { initial }]) => values[name as Name] === (preset[name as Name] ?? initial),
    );
  };
  const watch: Monitor = monitor(
    run,
    values,
    completeValues(spec.id, spec.parameters, {}) as ValuesOf<Name>,
    checks,
    hasValuesOf,
  );
  return {
    ...run,
    world,
    dt,
    values,
    ownIntegrator,
    picture: spec.picture(run, values),
    plots: plots.map((plot) => livePlot(plot, run, values)),
    histograms: (spec.histograms ?? []).map((histogram) => liveHistogram(histogram, run, values)),
    act(name, isDown) {
      if (isDown) spec.actions?.[name]?.press(run);
      else spec.actions?.[name]?.release?.(run);
    },
    point(name, at, from) {
      pointer?.[name]?.(run, at, from);
    },
    observe: watch.observe,
    checkStates: watch.states,
    isDone: watch.isDone,
  };
}

function livePlot<Run extends SceneRun, Values>(plot: Plot<Run, Values>, run: Run, values: Values): LivePlot {
  const { title, x, y, series } = plot;
  return {
    title,
    x: { label: x?.label ?? 't, s', value: x === undefined ? () => run.world.time : () => x.value(run) },
    y,
    series: series.map(({ label, value, exact }) => ({
      label,
      value: () => value(run),
      ...(exact === undefined ? {} : { exact: (time: number) => exact(time, values) }),
    })),
  };
}

function liveHistogram<Run extends SceneRun, Values>(
  { title, x, intervals, samples, exact }: Histogram<Run, Values>,
  run: Run,
  values: Values,
): LiveHistogram {
  return {
    title,
    x,
    densities: () => densities(samples(run), x.min, x.max, intervals),
    ...(exact === undefined ? {} : { exact: (at: number) => exact(at, run.world.time, values) }),
  };
}

/** @throws PhysicsError E_UNKNOWN, E_TYPE, E_NONFINITE, E_RANGE */
function completeValues(
  id: string,
  parameters: Readonly<Record<string, ExampleParameter>>,
  given: Readonly<Record<string, number>>,
): Record<string, number> {
  const names = Object.keys(parameters);
  const unknown = Object.keys(given).find((name) => !names.includes(name));
  if (unknown !== undefined) {
    throw new PhysicsError('E_UNKNOWN', `the example ${id} has no parameter "${unknown}".`, {
      field: unknown,
      hint: `Valid: ${names.join(', ')}.`,
    });
  }
  return Object.fromEntries(
    names.map((name) => [name, checkParameter(name, { about: '', unit: '', ...parameters[name] }, given[name])]),
  );
}
