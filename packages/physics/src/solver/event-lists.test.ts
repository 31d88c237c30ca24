// What the lists of events hold in worlds without rigid bodies, and of ids that are used again.
import {
  box,
  boxWalls,
  contactEvents,
  contactPoints,
  despawn,
  motionEvents,
  particleContacts,
  rigidBodies,
  sensorEvents,
  spawn,
  standard,
  step,
  uniformGravity,
  wallContacts,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';
import { warnedWorld } from '../../../../test/support/warned-world.ts';

describe.each([
  ['standard', standard],
  ['particleContacts', particleContacts],
])('in a world of the preset %s', (_name, preset) => {
  test.each([100, 10_000])('events of rigid bodies are empty and take no memory, with a capacity of %s', (capacity) => {
    const { world } = warnedWorld({ preset, capacity, forces: [uniformGravity()] });
    spawn(world, { position: {}, mass: 1, collider: 0.5 });
    step(world, DT);
    const { top } = world.internal.arena;
    const { begin, end, hit } = contactEvents(world);
    const { moved, asleep, awake } = motionEvents(world);
    const { begin: entered, end: left } = sensorEvents(world);
    const lists = [begin, end, hit, moved, asleep, awake, entered, left, contactPoints(world)];
    expect(lists.map(({ count }) => count)).toEqual(lists.map(() => 0));
    expect(contactEvents(world)).toBe(contactEvents(world));
    expect(world.internal.arena.top).toBe(top);
  });
});

test.each([
  ['standard', standard, 'particleContacts'],
  ['rigidBodies', rigidBodies, 'contactEvents'],
])('wallContacts warns in a world of the preset %s, once', (_name, preset, hint) => {
  const { world, warnings } = warnedWorld({ preset, walls: [boxWalls({ min: { y: 0 } })], forces: [uniformGravity()] });
  step(world, DT);
  for (let i = 0; i < 2; i++) expect(wallContacts(world).count).toBe(0);
  expect(warnings.map(({ message }) => message)).toEqual([expect.stringContaining('wallContacts(world) stays empty')]);
  expect(warnings[0].hint).toContain(hint);
});

test('wallContacts does not warn where walls are noted', () => {
  const { world, warnings } = warnedWorld({ preset: particleContacts });
  wallContacts(world);
  expect(warnings).toEqual([]);
});

test('a pair that is counted up at its begin and down at its end is right when an id is used again', () => {
  const world = rigidWorld();
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1) } });
  spawn(world, { position: { y: 1 }, collider: { shape: box(4, 2), sensor: true } });
  const block = () => spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });
  let [touching, inside, both] = [0, 0, 0];
  const advance = () => {
    for (let i = 0; i < 30; i++) {
      step(world, DT);
      const [contacts, sensors] = [contactEvents(world), sensorEvents(world)];
      touching += contacts.begin.count - contacts.end.count;
      inside += sensors.begin.count - sensors.end.count;
      if (contacts.begin.count > 0 && contacts.end.count > 0) both++;
    }
  };
  const first = block();
  advance();
  despawn(world, first);
  expect(block()).toBe(first);
  advance();
  expect([touching, inside, both]).toEqual([1, 1, 1]);
});
