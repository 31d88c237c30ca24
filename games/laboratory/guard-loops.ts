/** Ends loops of a reader's code that would not end by themselves, so that the page goes on. */
import type { Statement } from 'acorn';
import { WORDS } from './words.ts';

/** How long a piece of code may hold up the page, ms: far longer than any step takes. */
const LIMIT = 2000;
/** Iterations of loops between two readings of the clock. */
const ITERATIONS = 1000;

/** What a loop calls in each iteration, with its line. */
export type LoopGuard = (line: number) => void;

/** @param fail makes the error that ends a loop */
export function createLoopGuard(fail: (message: string, line: number) => Error, limit = LIMIT): LoopGuard {
  let iterations = 0;
  let start: number | undefined;
  return (line) => {
    if (++iterations < ITERATIONS) return;
    iterations = 0;
    if (start === undefined) {
      start = performance.now();
      // As soon as the code lets others run, its time begins anew.
      setTimeout(() => {
        start = undefined;
      });
    } else if (performance.now() - start > limit) {
      start = undefined;
      throw fail(WORDS.code.endlessLoop(limit / 1000), line);
    }
  };
}

/**
 * The same JavaScript, in which every loop calls the function `name` at the beginning of each iteration. Lines stay where they are.
 * @throws SyntaxError that names the place as “(12:5)”
 */
export async function guardLoops(script: string, name: string): Promise<string> {
  const [{ parse }, { simple }] = await Promise.all([import('acorn'), import('acorn-walk')]);
  const insertions: { at: number; text: string }[] = [];
  const guard = ({ body, loc }: { readonly body: Statement; readonly loc?: { start: { line: number } } | null }) => {
    const call = `${name}(${loc?.start.line ?? 0});`;
    if (body.type === 'BlockStatement') insertions.push({ at: body.start + 1, text: call });
    else insertions.push({ at: body.start, text: `{${call}` }, { at: body.end, text: '}' });
  };
  simple(parse(script, { ecmaVersion: 'latest', sourceType: 'script', locations: true }), {
    ForStatement: guard,
    ForInStatement: guard,
    ForOfStatement: guard,
    WhileStatement: guard,
    DoWhileStatement: guard,
  });
  // From the end, so that places before stay right; at one place an inner loop closes before the outer one.
  return insertions
    .map((insertion, order) => ({ ...insertion, order }))
    .sort((a, b) => b.at - a.at || b.order - a.order)
    .reduce((text, { at, text: more }) => text.slice(0, at) + more + text.slice(at), script);
}
