/** Short ways to say what an example checks. */
import type { Check } from './check.ts';

/** What a figure must be, and how exactly: to a fraction of it (`relative`), or to a number in its unit (`absolute`). */
export type Expected<Values> = Pick<Check<never, Values>, 'exact' | 'holds' | 'unit' | 'integrator' | 'preset'> &
  ({ readonly relative: number } | { readonly absolute: number });

type Figure<Run, Values> = (
  time: number,
  label: string,
  expected: Expected<Values>,
  measure: (run: Run) => number,
) => Check<Run, Values>;

/** Figures of the usual kinds. Times are in s. */
export interface Figures<Run, Values> {
  /** What is measured at a time. */
  readonly at: Figure<Run, Values>;
  /** The largest value of all steps until a time. */
  readonly largest: Figure<Run, Values>;
  readonly smallest: Figure<Run, Values>;
  readonly mean: Figure<Run, Values>;
}

export function figuresOf<Run, Values>(): Figures<Run, Values> {
  const upTo =
    (take: 'largest' | 'smallest' | 'mean'): Figure<Run, Values> =>
    (until, label, expected, measure) => ({ label, ...checkOf(expected), at: { until, take }, measure });
  return {
    at: (time, label, expected, measure) => ({ label, ...checkOf(expected), at: { time }, measure }),
    largest: upTo('largest'),
    smallest: upTo('smallest'),
    mean: upTo('mean'),
  };
}

function checkOf<Values>(expected: Expected<Values>): Omit<Check<never, Values>, 'label' | 'at' | 'measure'> {
  const { exact, holds, unit, integrator, preset } = expected;
  return {
    exact,
    ...(holds === undefined ? {} : { holds }),
    ...(unit === undefined ? {} : { unit }),
    ...(integrator === undefined ? {} : { integrator }),
    ...(preset === undefined ? {} : { preset }),
    tolerance: 'relative' in expected ? { relative: expected.relative } : { absolute: expected.absolute },
  };
}
