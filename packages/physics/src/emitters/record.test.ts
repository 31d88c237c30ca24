import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import * as record from './record.ts';
import { MAX_RAMPS, MAX_STOPS, W } from './record.ts';

/** The enumerations as objects, which they are wherever files are compiled one by one, as here. */
const enumerations = record as unknown as Readonly<Record<'N' | 'W', object>>;

/** The members of an enumeration without `count`, in order; those numbered from 0 that stand for several, each. */
function namesOf(fields: object): string[] {
  const names = Object.entries(fields).filter(([, place]) => typeof place === 'number') as [string, number][];
  return names.slice(0, -1).flatMap(([name, place], i) => {
    const count = names[i + 1][1] - place;
    return count === 1 ? [name] : Array.from({ length: count }, (_, k) => name.replace('0', String(k)));
  });
}

test('the record has the fields of the kernel’s class, in its order, and its f64 are aligned', () => {
  const source = readFileSync(new URL('../../kernels/emitters/record.ts', import.meta.url), 'utf8');
  const [body] = source.slice(source.indexOf('class Emitter')).split('\n}');
  const fields = [...body.matchAll(/^ {2}(\w+): (\w+);/gm)];
  expect(fields.filter(([, , type]) => type !== 'f64').map(([, name]) => name)).toEqual(namesOf(enumerations.W));
  expect(fields.filter(([, , type]) => type === 'f64').map(([, name]) => name)).toEqual(namesOf(enumerations.N));
  expect(fields.findIndex(([, , type]) => type === 'f64')).toBe(W.count);
  expect(W.count % 2).toBe(0);
  expect(W.count - W.color0).toBe(MAX_RAMPS * MAX_STOPS + MAX_RAMPS);
});
