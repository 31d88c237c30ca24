/** Turns the source of an example into the example, in the browser. */
import type { Example } from '@principia/scenes/examples';
import { MODULES } from './example-modules.gen.ts';
import { createLoopGuard, guardLoops } from './guard-loops.ts';
import { limitedConsole } from './limited-console.ts';
import { WORDS } from './words.ts';

/** Name of the source in stack traces. */
const FILE = 'example.ts';
/** Lines that a function made from text has before the text. */
const LINES_BEFORE = 2;
/** Name of the function that loops call. */
const GUARD = 'guardLoop';

/** An error in the source of an example. */
export class CodeError extends Error {
  /** Line of the source, from 1; undefined if it is not known. */
  readonly line: number | undefined;

  constructor(message: string, line: number | undefined) {
    super(message);
    this.line = line;
  }
}

/** @throws CodeError with the line, if it is known */
export async function exampleFrom(source: string): Promise<Example> {
  const script = await withoutTypes(source);
  const modules = new Map<string, unknown>();
  for (const [, name] of script.matchAll(/require\('([^']+)'\)/g)) {
    const load = MODULES[name];
    // What is only in a comment or a text is not asked for.
    if (load !== undefined) modules.set(name, await load());
  }
  const guarded = await guarding(script);
  const exported: { default?: unknown } = {};
  try {
    const run = new Function('require', 'exports', 'console', GUARD, `${guarded}\n//# sourceURL=${FILE}`);
    run(
      (name: string) => {
        if (modules.has(name)) return modules.get(name);
        throw codeError(new Error(WORDS.code.noModule(name, Object.keys(MODULES).join(', '))));
      },
      exported,
      limitedConsole((message) => codeError(new Error(message))),
      createLoopGuard((message, line) => new CodeError(message, line)),
    );
  } catch (error) {
    throw codeError(error);
  }
  if (!isExample(exported.default)) {
    throw new CodeError(WORDS.code.noExample, undefined);
  }
  return exported.default;
}

/** The error with the line of the source where it happened. */
export function codeError(error: unknown): CodeError {
  if (error instanceof CodeError) return error;
  const { message, stack = '' } = error instanceof Error ? error : new Error(String(error));
  const line = stack.match(new RegExp(`${FILE}:(\\d+)`))?.[1];
  return new CodeError(message, line === undefined ? undefined : Number(line) - LINES_BEFORE);
}

async function withoutTypes(source: string): Promise<string> {
  const { transform } = await import('sucrase');
  try {
    return transform(source, { transforms: ['typescript', 'imports'], production: true }).code;
  } catch (error) {
    // Sucrase names the place as “(12:5)”.
    const { message } = error as Error;
    const line = message.match(/\((\d+):\d+\)/)?.[1];
    const text = message.replace(/^Error transforming[^:]*: /, '').replace(/\s*\(\d+:\d+\)/, '');
    throw new CodeError(text, line === undefined ? undefined : Number(line));
  }
}

/** The script with guarded loops. @throws CodeError for what only a browser's JavaScript refuses */
async function guarding(script: string): Promise<string> {
  try {
    return await guardLoops(script, GUARD);
  } catch (error) {
    // Acorn names the place as “(12:5)” and by itself; lines are those of the source.
    const { message, loc } = error as SyntaxError & { readonly loc?: { readonly line: number } };
    throw new CodeError(message.replace(/\s*\(\d+:\d+\)$/, ''), loc?.line);
  }
}

const isExample = (value: unknown): value is Example =>
  typeof (value as Partial<Example> | undefined)?.start === 'function';
