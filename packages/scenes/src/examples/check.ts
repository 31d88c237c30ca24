/** The figures that prove an example right: what is measured, when, and what it must be. */
import { type Integrator, keepState, type PhysicsWorld } from '@principia/physics';

/** When the measurement of a check is taken. */
export type Moment<Run> =
  /** At a time, s. */
  | { readonly time: number }
  /**
   * When `event` rises through zero for the `count`-th time (default: the first). The measured value is interpolated
   * between the two steps.
   */
  | { readonly event: (run: Run) => number; readonly count?: number }
  /** The change of the measured value between two such events, as for a period. */
  | { readonly event: (run: Run) => number; readonly from: number; readonly to: number }
  /** The largest, smallest or mean value of all steps until a time, s. */
  | { readonly until: number; readonly take: 'largest' | 'smallest' | 'mean' };

/** The tolerance of a figure: a fraction of it, or a number in its unit. */
export type Tolerance = { readonly relative: number } | { readonly absolute: number };

/** A figure of an example. */
export interface Check<Run, Values> {
  /** Says what is measured, such as `Period of a small bob`. */
  readonly label: string;
  /** Left out for a plain number. */
  readonly unit?: string;
  /**
   * The exact value; a plain number holds for the default values of the parameters only, and a function for all values for
   * which it is finite.
   */
  readonly exact: number | ((values: Values) => number);
  /** For which values of the parameters the function `exact` holds; left out, for all. */
  readonly holds?: (values: Values) => boolean;
  readonly tolerance: Tolerance;
  readonly at: Moment<Run>;
  /** Left out, the time, s, as for when something happens. */
  readonly measure?: (run: Run) => number;
  /** The integrator that the figure is about; left out, the one that the example uses by default. */
  readonly integrator?: Integrator;
  /** Label of the preset that the figure belongs to; left out, the default values. */
  readonly preset?: string;
}

/** The state of a check. */
export interface CheckState {
  /** `no figure` where the exact value does not hold for the values of the parameters. */
  readonly state: 'waiting' | 'passed' | 'failed' | 'not applicable' | 'no figure';
  /** The measured value; NaN while waiting. */
  readonly computed: number;
  readonly exact: number;
  /** |computed − exact|, as a fraction of the exact value for a relative tolerance; 0 where it is rounding alone. */
  readonly error: number;
}

/** Numbers of a check that is under way, which rewinding restores. */
interface Progress {
  done: boolean;
  result: number;
  /** Events so far. */
  count: number;
  /** Event function and measured value of the step before. */
  lastEvent: number;
  lastValue: number;
  /** Measured value at the first of two events, or the sum of all values for a mean. */
  base: number;
  steps: number;
}

/** The checks of one run. */
export interface Monitor {
  /** Takes measurements of the present state; called several times for one state it measures once. */
  observe(): void;
  /** The state of each check. */
  states(): readonly CheckState[];
  /** Whether no check is waiting. */
  isDone(): boolean;
}

/** The parts of a run that checks need. */
interface Watched {
  readonly world: PhysicsWorld;
  readonly dt: number;
}

/**
 * A difference this small against the exact value of the default settings is rounding: some ten thousand roundings of f64, of
 * 1.1e-16 each. It counts where the exact value itself is about 0.
 */
const ROUNDING = 1e-12;

/**
 * Watches the checks of a run: at the start of every step, and whenever `observe` is called. Rewinding the world rewinds
 * the checks.
 * @param defaults the default values of the parameters
 * @param hasValuesOf whether the parameters have the values of the preset of a label, or without one the default values
 */
export function monitor<Run extends Watched, Values>(
  run: Run,
  values: Values,
  defaults: Values,
  checks: readonly Check<Run, Values>[],
  hasValuesOf: (preset?: string) => boolean,
): Monitor {
  const progress = checks.map(newProgress);
  const seen = { tick: -1 };
  const { world } = run;
  keepState(world, seen, ...progress);
  const limits = checks.map((check): Limits => {
    const { exact, integrator, preset, holds } = check;
    const isOwn = integrator === undefined || integrator.name === world.integrator.name;
    const isMeant = isOwn && (hasValuesOf(preset) || (typeof exact === 'function' && preset === undefined));
    const expected = exactOf(check, values);
    const isKnown = Number.isFinite(expected) && (holds?.(values) ?? true);
    const reason = isMeant ? (isKnown ? undefined : 'no figure') : 'not applicable';
    return { expected, rounding: ROUNDING * Math.abs(exactOf(check, defaults)), reason };
  });
  const observe = () => {
    if (seen.tick === world.tick) return;
    seen.tick = world.tick;
    for (let i = 0; i < checks.length; i++) {
      if (limits[i].reason === undefined && !progress[i].done) measureOnce(run, checks[i], progress[i]);
    }
  };
  world.phases.input.unshift(observe);
  observe();
  return {
    observe,
    states: () => checks.map((check, i) => stateOf(check, limits[i], progress[i])),
    isDone: () => progress.every(({ done }, i) => done || limits[i].reason !== undefined),
  };
}

/** What a check is judged by. */
interface Limits {
  readonly expected: number;
  /** A difference that is rounding alone. */
  readonly rounding: number;
  /** Why it is not judged. */
  readonly reason: 'not applicable' | 'no figure' | undefined;
}

function exactOf<Values>({ exact }: Pick<Check<never, Values>, 'exact'>, values: Values): number {
  return typeof exact === 'function' ? exact(values) : exact;
}

function newProgress(): Progress {
  const none = Number.NaN;
  return { done: false, result: none, count: 0, lastEvent: none, lastValue: none, base: 0, steps: 0 };
}

function stateOf<Run, Values>(
  { tolerance }: Check<Run, Values>,
  { expected, rounding, reason }: Limits,
  { done, result }: Progress,
): CheckState {
  const difference = Math.abs(result - expected);
  const fraction = difference <= rounding ? 0 : difference / Math.abs(expected);
  const error = 'relative' in tolerance ? fraction : difference;
  const limit = 'relative' in tolerance ? tolerance.relative : tolerance.absolute;
  const judged = error <= limit ? 'passed' : 'failed';
  return { state: reason ?? (done ? judged : 'waiting'), computed: result, exact: expected, error };
}

function measureOnce<Run extends Watched>(run: Run, check: Check<Run, never>, progress: Progress): void {
  const { at } = check;
  const { time } = run.world;
  // Sums of steps are off by rounding, so a time counts as reached half a step early.
  const reached = (moment: number) => time > moment - run.dt / 2;
  if ('time' in at) {
    if (reached(at.time)) finish(progress, measured(run, check));
  } else if ('until' in at) {
    accumulate(progress, measured(run, check), at.take);
    if (reached(at.until)) finish(progress, at.take === 'mean' ? progress.base / progress.steps : progress.base);
  } else watchEvent(run, at, measured(run, check), progress);
}

/** Called only when it counts: what is measured may be a run of its own. */
function measured<Run extends Watched>(run: Run, { measure }: Check<Run, never>): number {
  return measure === undefined ? run.world.time : measure(run);
}

function finish(progress: Progress, result: number): void {
  progress.done = true;
  progress.result = result;
}

function accumulate(progress: Progress, value: number, take: 'largest' | 'smallest' | 'mean'): void {
  const isFirst = progress.steps++ === 0;
  if (take === 'mean') progress.base += value;
  else if (isFirst || (take === 'largest' ? value > progress.base : value < progress.base)) progress.base = value;
}

function watchEvent<Run>(
  run: Run,
  at: Extract<Moment<Run>, { event: unknown }>,
  value: number,
  progress: Progress,
): void {
  const event = at.event(run);
  const { lastEvent, lastValue } = progress;
  progress.lastEvent = event;
  progress.lastValue = value;
  if (!(lastEvent < 0 && event >= 0)) return;
  progress.count++;
  const there = lastValue + ((value - lastValue) * lastEvent) / (lastEvent - event);
  if (!('from' in at)) {
    if (progress.count === (at.count ?? 1)) finish(progress, there);
    return;
  }
  if (progress.count === at.from) progress.base = there;
  if (progress.count === at.to) finish(progress, there - progress.base);
}
