import { readFileSync } from 'node:fs';
import { step } from '@principia/physics';
import { expect, test } from 'vitest';
import { exampleFrom } from './run-code.ts';

const source = readFileSync('packages/scenes/src/examples/ch05/floating-ball.ts', 'utf8');

test('makes the example that its source describes', async () => {
  const example = await exampleFrom(source.replace("title: 'A ball thrown into water'", "title: 'Mine'"));
  expect(example.title).toBe('Mine');
  const run = example.start();
  step(run.world, run.dt);
  expect(run.world.tick).toBe(1);
});

const lineOf = (text: string) => source.slice(0, source.indexOf(text)).split('\n').length;

test.each([
  ['of the syntax', 'mass: 1, hull', 'mass: 1 hull', /Unexpected token/],
  ['of an import', "from '../define-example.ts'", "from '../nothing.ts'", /There is no module “\.\.\/nothing\.ts”/],
  ['outside of functions', 'const LEVEL = 300', 'const LEVEL = three', /three is not defined/],
])('names the line of a mistake %s', async (_, from, to, message) => {
  expect(source).toContain(from);
  const error = await exampleFrom(source.replace(from, to)).then(
    () => undefined,
    (reason) => reason,
  );
  expect(error.message).toMatch(message);
  // The line of an import is not known.
  if (error.line !== undefined) expect(error.line).toBe(lineOf(from));
  else expect(to).toContain('nothing');
});

test('wants an example', async () => {
  await expect(exampleFrom('export default 3;')).rejects.toThrow('exports no example');
});
