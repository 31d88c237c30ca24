/** The console of a reader's code: it takes no more lines at once than a page survives. */
import { WORDS } from './words.ts';

/** Lines that a piece of code may print before it lets others run: they take a slow computer less than the time of a loop. */
const MAX_LINES = 2_000;
const METHODS = ['log', 'info', 'debug', 'warn', 'error'] as const;

/** @param fail makes the error that ends code which prints too much */
export function limitedConsole(fail: (message: string) => Error, limit = MAX_LINES): Console {
  let lines = 0;
  const count = () => {
    // As soon as the code lets others run, the count begins anew.
    if (lines === 0) {
      setTimeout(() => {
        lines = 0;
      });
    }
    if (++lines > limit) throw fail(WORDS.code.printsTooMuch(limit));
  };
  const limited = METHODS.map((method) => {
    const print = (...values: unknown[]) => {
      count();
      console[method](...values);
    };
    return [method, print] as const;
  });
  return Object.assign(Object.create(console), Object.fromEntries(limited)) as Console;
}
