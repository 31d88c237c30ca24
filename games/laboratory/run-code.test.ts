import { readdirSync, readFileSync } from 'node:fs';
import { step } from '@principia/physics';
import { expect, test, vi } from 'vitest';
import { createLoopGuard, guardLoops } from './guard-loops.ts';
import { NEW_SOURCE } from './new-example.ts';
import { exampleFrom } from './run-code.ts';

const source = readFileSync('packages/scenes/src/examples/ch05/floating-ball.ts', 'utf8');

test('makes the example that its source describes', async () => {
  const example = await exampleFrom(source.replace("title: 'A ball thrown into water'", "title: 'Mine'"));
  expect(example.title).toBe('Mine');
  const run = example.start();
  step(run.world, run.dt);
  expect(run.world.tick).toBe(1);
});

test('an example of one’s own begins as the first game: a ball that can be kicked, until it touches the floor', async () => {
  const run = (await exampleFrom(NEW_SOURCE)).start();
  const label = run.picture.labels?.[0].text;
  const score = () => (typeof label === 'function' ? label() : label);
  run.act('action', true);
  expect(score()).toBe('1 kicks');
  for (let i = 0; i < 600; i++) step(run.world, run.dt);
  expect(score()).toBe('0 kicks');
  expect(run.world.faults.faults).toEqual([]);
});

test('finds every module that the source of an example imports', async () => {
  const folder = 'packages/scenes/src/examples';
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) => /^ch\d\d/.test(file));
  const sources = files.filter((file) => file.endsWith('.ts')).map((file) => readFileSync(`${folder}/${file}`, 'utf8'));
  // One example for each module is enough, and each takes a while.
  const seen = new Set<string>();
  for (const text of sources) {
    const names = [...text.matchAll(/^} from '(.*)'|^import (?!type).* from '(.*)'/gm)].map(([, a, b]) => a ?? b);
    if (names.every((name) => seen.has(name))) continue;
    for (const name of names) seen.add(name);
    expect((await exampleFrom(text)).id).toBe(/id: '(.*)'/.exec(text)?.[1]);
  }
  expect(seen.size).toBeGreaterThan(30);
});

const lineOf = (text: string) => source.slice(0, source.indexOf(text)).split('\n').length;

test.each([
  ['of the syntax', 'mass: 1, hull', 'mass: 1 hull', /Unexpected token/],
  ['of an import', "from '../define-example.ts'", "from '../nothing.ts'", /There is no module “\.\.\/nothing\.ts”/],
  ['that the second reader finds', 'const LEVEL = 300', 'const LEVEL = await 300', /^Unexpected token$/],
  ['outside of functions', 'const LEVEL = 300', 'const LEVEL = three', /three is not defined/],
])('names the line of a mistake %s', async (_, from, to, message) => {
  expect(source).toContain(from);
  const error = await exampleFrom(source.replace(from, to)).then(
    () => undefined,
    (reason) => reason,
  );
  expect(error.message).toMatch(message);
  expect(error.line).toBe(lineOf(from));
});

test('a module that only a comment names is not asked for', async () => {
  const example = await exampleFrom(`// as require('fs') does\n${source}`);
  expect(example.id).toBe('ch05-floating-ball');
});

test('wants an example', async () => {
  await expect(exampleFrom('export default 3;')).rejects.toThrow('exports no example');
});

test.each([
  ['for (;;) {}', 1],
  ['for (;;) ;', 1],
  ['let i = 0;\nwhile (i < 1) i *= 2;', 2],
  ['let i = 0;\n\ndo i++; while (i > 0);', 3],
  ['for (;;) for (let k = 0; k < 3; k++) if (k > 5) break; else continue;', 1],
  ['const all = [1];\nfor (const x of all) { all.push(x); all.shift(); all.unshift(x); }', 2],
  ['label: while (true) { do { continue label; } while (true) }', 1],
])('ends the loop %j, and names its line', async (code, line) => {
  const guarded = await guardLoops(code, 'guard');
  expect(guarded.split('\n')).toHaveLength(code.split('\n').length);
  const guard = createLoopGuard((message, at) => Object.assign(new Error(message), { at }), 20);
  let error: unknown;
  try {
    new Function('guard', guarded)(guard);
  } catch (reason) {
    error = reason;
  }
  expect(error).toMatchObject({ at: line, message: expect.stringContaining('did not come to an end') });
});

test('leaves loops that end as they are, however many', async () => {
  const code = 'let sum = 0; for (let i = 0; i < 1e5; i++) { for (const k in [1, 2]) sum += Number(k); } return sum;';
  const guard = createLoopGuard((message) => new Error(message));
  const inFunction = `return (() => { ${code} })();`;
  const guarded = await guardLoops(`(function () { ${code} })`, 'guard');
  expect(new Function('guard', `return ${guarded}()`)(guard)).toBe(new Function(inFunction)());
});

test('ends code that prints a million lines, and names the line; a few lines are printed', async () => {
  const log = vi.spyOn(console, 'log').mockImplementation(() => {});
  const printing = (count: number) =>
    exampleFrom(source.replace('const body =', `for (let i = 0; i < ${count}; i++) console.log(i); const body =`));
  (await printing(100)).start();
  expect(log).toHaveBeenCalledTimes(100);
  const flood = await printing(1e6);
  let error: unknown;
  try {
    flood.start();
  } catch (reason) {
    error = reason;
  }
  expect(error).toMatchObject({
    line: lineOf('const body ='),
    message: expect.stringContaining('more than 2000 lines'),
  });
  expect(log).toHaveBeenCalledTimes(100 + 2000);
  log.mockRestore();
});

test('ends a loop that begins in a step only', async () => {
  const late = source.replace(
    'const body =',
    'world.phases.input.push(() => { while (world.tick > 2) {} }); const body =',
  );
  const run = (await exampleFrom(late)).start();
  const steps = () => {
    for (let i = 0; i < 5; i++) step(run.world, run.dt);
  };
  expect(steps).toThrow(/did not come to an end/);
});
