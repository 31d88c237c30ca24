import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { NUMBERS, WORDS } from './record';

test('the record has the fields of the kernel’s class, in its order, and its f64 are aligned', () => {
  const source = readFileSync(new URL('../../kernels/emitters/record.ts', import.meta.url), 'utf8');
  const [body] = source.slice(source.indexOf('class Emitter')).split('\n}');
  const fields = [...body.matchAll(/^ {2}(\w+): (\w+);/gm)];
  expect(fields.filter(([, , type]) => type !== 'f64').map(([, name]) => name)).toEqual(WORDS);
  expect(fields.filter(([, , type]) => type === 'f64').map(([, name]) => name)).toEqual(NUMBERS);
  expect(fields.findIndex(([, , type]) => type === 'f64')).toBe(WORDS.length);
  expect(WORDS.length % 2).toBe(0);
});
