/** What the reader's plot shows, as the address names it: `Position.y,Position.x,2`. */
import { COMPONENTS } from '@principia/physics';
import { type OwnQuantities, TOTALS, totalsOf } from './plot-sources.ts';

/** What is plotted, against what, and of which body. */
export interface PlotChoice {
  /** A total such as `Energy`, a column such as `Position.y`, or a quantity of the game's own. */
  readonly what: string;
  /**
   * Along the horizontal axis: a column, a component of a total such as `Energy.kinetic`, or a quantity of the game's own;
   * empty for the time.
   */
  readonly against: string;
  /** Number of the body, or 0 for all. */
  readonly body: number;
}

/** Stands in the address for a plot that is not shown. */
export const NO_PLOT = 'off';

/** @returns undefined if a world of these dimensions has no such plot */
export function readPlotChoice(text: string, dimensions: 2 | 3, own: OwnQuantities = {}): PlotChoice | undefined {
  const [what, against = '', number = '0', ...more] = text.split(',');
  const body = /^\d{1,7}$/.test(number) ? Number(number) : -1;
  const isSingle = (name: string) => Object.hasOwn(own, name) || isColumn(name);
  const isKnown =
    ((TOTALS as readonly string[]).includes(what) || isSingle(what)) &&
    (against === '' || totalsOf(dimensions).includes(against) || isSingle(against));
  return isKnown && body >= 0 && more.length === 0 ? { what, against, body } : undefined;
}

/** What `readPlotChoice` reads; parts at the end that say nothing are left out. */
export function writePlotChoice({ what, against, body }: PlotChoice): string {
  return [what, against, body || ''].join().replace(/,+$/, '');
}

function isColumn(name: string): boolean {
  const [component, field, ...more] = name.split('.');
  if (field === undefined || more.length > 0 || !Object.hasOwn(COMPONENTS, component)) return false;
  return Object.hasOwn(COMPONENTS[component as keyof typeof COMPONENTS].fields, field);
}
