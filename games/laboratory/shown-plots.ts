/** How the plots of an example are shown. They are counted from 1, histograms after the others, and the address names them so. */
import { WORDS } from './words.ts';

/** Plots of which only the title is shown. */
const folded = new Set<number>();
/** Plots of the errors against the exact solution. */
const errors = new Set<number>();

export const SHOWN_PLOTS = { folded, errors } as const;

/** Takes the numbers of plots out of a query. @param count of plots @returns a sentence for each part that was rejected */
export function takeShownPlots(query: URLSearchParams, count: number): string[] {
  return Object.entries(SHOWN_PLOTS).flatMap(([name, plots]) => {
    const text = query.get(name);
    query.delete(name);
    plots.clear();
    if (text === null) return [];
    const numbers = text.split(',').map(Number);
    const areNumbers = numbers.every((number) => Number.isInteger(number) && number >= 1 && number <= count);
    if (!areNumbers) return [WORDS.address.plots(name, count, text)];
    for (const number of numbers) plots.add(number);
    return [];
  });
}

/** Writes them into a query. */
export function writeShownPlots(query: URLSearchParams): void {
  for (const [name, plots] of Object.entries(SHOWN_PLOTS)) {
    if (plots.size === 0) query.delete(name);
    else query.set(name, [...plots].sort((a, b) => a - b).join());
  }
}
