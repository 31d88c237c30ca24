// Contacts are reported when they begin, when they end, and when they are hard.
import {
  box,
  contactEvents,
  contactPoints,
  createPhysicsWorld,
  despawn,
  rigidBodies,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, test } from 'vitest';

const DT = 1 / 60;

test('a ball that falls and bounces begins a contact, hits with √(2 g h), and ends the contact', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 100 });
  const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1), restitution: 0.8 } });
  const ball = spawn(world, { position: { x: 1, y: 2.5 }, collider: { radius: 0.5, density: 1 } });
  const events = contactEvents(world);
  const seen: string[] = [];
  for (let i = 0; i < 60 && seen.length < 3; i++) {
    step(world, DT);
    for (const name of ['begin', 'hit', 'end'] as const) {
      for (let k = 0; k < events[name].count; k++) {
        expect([events[name].a[k], events[name].b[k]]).toEqual([ground, ball]);
        seen.push(name);
      }
    }
    if (events.hit.count === 0) continue;
    // The speed is that before the step: up to g dt less than at the impact.
    const speed = Math.sqrt(2 * 9.80665 * 2);
    expect(Math.abs(events.hit.speed[0] - speed)).toBeLessThan(2 * 9.80665 * DT);
    expect(events.hit.x[0]).toBeCloseTo(1, 6);
    // The point is in the middle of an overlap of up to v dt.
    expect(Math.abs(events.hit.y[0])).toBeLessThan(0.5 * speed * DT);
    expect([events.hit.nx[0], events.hit.ny[0]]).toEqual([0, 1]);
  }
  expect(seen).toEqual(['begin', 'hit', 'end']);
});

test('a contact ends with its body', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 100 });
  const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1) } });
  const body = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });
  for (let i = 0; i < 60; i++) step(world, DT);
  const { end } = contactEvents(world);
  expect(end.count).toBe(0);
  despawn(world, body);
  step(world, DT);
  expect([end.count, end.a[0], end.b[0]]).toEqual([1, ground, body]);
});

test('a contact that begins has its point, normal, speed of approach, and the impulse m Δv', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, precision: 'f64', forces: [], capacity: 50 });
  const wall = spawn(world, { position: {}, collider: { shape: box(1, 4) } });
  const collider = { radius: 0.25, density: 8, restitution: 0.5 };
  const ball = spawn(world, { position: { x: -1.5, y: 0.5 }, velocity: { x: 4 }, collider });
  const { begin, hit } = contactEvents(world);
  const mass = world.components.Mass.value[ball];
  while (begin.count === 0) step(world, 1 / 60);
  expect([begin.a[0], begin.b[0], begin.nx[0]]).toEqual([wall, ball, -1]);
  expect(begin.x[0]).toBeCloseTo(-0.5, 1);
  expect(begin.y[0]).toBeCloseTo(0.5, 6);
  expect(begin.speed[0]).toBeCloseTo(4, 6);
  // It may come near in one step and be hit in the next.
  if (hit.count === 0) step(world, 1 / 60);
  expect(hit.speed[0]).toBeCloseTo(4, 6);
  expect(hit.impulse[0]).toBeCloseTo(mass * (4 - world.components.Velocity.x[ball]), 6);
});

test.each([
  [0.019, 1],
  [0.021, 0],
])('a box that hovers %d m above the ground begins %d contacts, ends none, and presses on nothing', (gap, begins) => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 100 });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1) } });
  spawn(world, {
    position: { y: 0.025 + gap },
    velocity: { x: 0.01 },
    collider: { shape: box(0.05, 0.05), density: 1 },
  });
  const events = contactEvents(world);
  const counts = { begin: 0, end: 0 };
  for (let i = 0; i < 60; i++) {
    step(world, DT);
    for (const name of ['begin', 'end'] as const) counts[name] += events[name].count;
    for (let k = 0; k < events.begin.count; k++) expect(events.begin.impulse[k]).toBe(0);
    const { count, impulse } = contactPoints(world);
    for (let k = 0; k < count; k++) expect(impulse[k]).toBe(0);
  }
  expect(counts).toEqual({ begin: begins, end: 0 });
});
