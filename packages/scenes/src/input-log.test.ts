import { expect, test } from 'vitest';
import { InputLog } from './input-log';

test('inputs wait for the next step, and play again from the log', () => {
  const first = new InputLog<string>();
  const seen: string[] = [];
  first.add('a');
  first.add('b');
  first.take(3, (input) => seen.push(`3${input}`));
  first.take(4, (input) => seen.push(`4${input}`));
  first.add('c');
  first.take(7, (input) => seen.push(`7${input}`));
  expect(seen).toEqual(['3a', '3b', '7c']);

  const second = new InputLog(first.entries);
  const again: string[] = [];
  for (let tick = 0; tick < 10; tick++) second.take(tick, (input) => again.push(`${tick}${input}`));
  expect(again).toEqual(seen);
  expect(second.entries).toEqual(first.entries);
});
