import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import * as record from './record.ts';
import { MAX_RAMPS, MAX_STOPS, W } from './record.ts';

/** Vitest compiles files one by one, so the const enums are objects here. */
const enumerations = record as unknown as Readonly<Record<'N' | 'W', object>>;

/** Returns the members of an enum without `count`, in order; a member that stands for several fields is expanded. */
function namesOf(fields: object): string[] {
  const names = Object.entries(fields).filter(([, place]) => typeof place === 'number') as [string, number][];
  return names.slice(0, -1).flatMap(([name, place], i) => {
    const count = names[i + 1][1] - place;
    return count === 1 ? [name] : Array.from({ length: count }, (_, k) => name.replace('0', String(k)));
  });
}

test('the record has the fields of the kernel class in the same order, and its f64 are aligned', () => {
  const source = readFileSync(new URL('../../kernels/emitters/record.ts', import.meta.url), 'utf8');
  const [body] = source.slice(source.indexOf('class Emitter')).split('\n}');
  const fields = [...body.matchAll(/^ {2}(\w+): (\w+);/gm)];
  expect(fields.filter(([, , type]) => type !== 'f64').map(([, name]) => name)).toEqual(namesOf(enumerations.W));
  expect(fields.filter(([, , type]) => type === 'f64').map(([, name]) => name)).toEqual(namesOf(enumerations.N));
  expect(fields.findIndex(([, , type]) => type === 'f64')).toBe(W.count);
  expect(W.count % 2).toBe(0);
  expect(W.count - W.color0).toBe(MAX_RAMPS * MAX_STOPS + MAX_RAMPS);
});
