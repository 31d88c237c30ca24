import { createPhysicsWorld, keepState, restore, snapshot } from '@principia/physics';
import { expect, test } from 'vitest';
import { InputLog } from './input-log.ts';

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

test('leaves the rest of an earlier game out when told', () => {
  const log = new InputLog([
    { tick: 0, input: 'a' },
    { tick: 5, input: 'b' },
  ]);
  const used: string[] = [];
  log.take(0, (input) => used.push(input));
  expect(log.isScripted).toBe(true);
  log.endScript();
  log.take(9, (input) => used.push(input));
  expect([used, log.isScripted]).toEqual([['a'], false]);
});

test('forgets what was taken since a moment it is sent back to, and takes its script again', () => {
  const log = new InputLog([{ tick: 1, input: 'scripted' }]);
  const used: string[] = [];
  const use = (input: string) => used.push(input);
  log.take(0, use);
  const world = createPhysicsWorld();
  keepState(world, log.state);
  const moment = snapshot(world);
  log.add('first');
  log.take(1, use);
  log.add('waiting');
  restore(world, moment);
  log.add('second');
  log.take(1, use);
  expect(used).toEqual(['scripted', 'first', 'scripted', 'second']);
  expect(log.entries).toEqual([
    { tick: 1, input: 'scripted' },
    { tick: 1, input: 'second' },
  ]);
});
