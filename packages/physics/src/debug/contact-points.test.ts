import {
  box,
  circle,
  contactPoints,
  createPhysicsWorld,
  rigidBodies,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, it } from 'vitest';

it.each(['f32', 'f64'] as const)('the contact points of a resting box carry its weight, %s', (precision) => {
  const [g, dt] = [10, 1 / 60];
  const world = createPhysicsWorld({
    preset: rigidBodies,
    forces: [uniformGravity({ y: -g })],
    capacity: 100,
    precision,
  });
  const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
  const body = spawn(world, {
    position: { x: 3, y: 0.5 },
    collider: { shape: box(1, 1), density: 2, friction: 0.6 },
  });
  const list = contactPoints(world);
  expect(list.count).toBe(0);
  for (let i = 0; i < 60; i++) step(world, dt);
  expect(contactPoints(world, list)).toBe(list);
  expect(list.count).toBe(2);
  const [left, right] = list.x.slice(0, 2).sort((p, q) => p - q);
  expect([left, right]).toEqual([expect.closeTo(2.5, 3), expect.closeTo(3.5, 3)]);
  expect([list.a[0], list.b[0], list.nx[0], list.ny[0]]).toEqual([floor, body, expect.closeTo(0, 5), 1]);
  expect(Math.abs(list.y[0])).toBeLessThan(0.005);
  // Two contacts together: m g dt.
  expect((list.impulse[0] + list.impulse[1]) / (2 * g * dt)).toBeCloseTo(1, 3);
});

it.each(['f32', 'f64'] as const)(
  'what slides slips as fast as it moves, and what rolls or is carried does not, %s',
  (precision) => {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      forces: [uniformGravity({ y: -10 })],
      capacity: 100,
      precision,
    });
    const spawnAt = (x: number, more: object) => spawn(world, { position: { x, y: 0.5 }, ...more });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 1 } });
    spawn(world, { position: { x: 40, y: -0.5 }, collider: { shape: box(20, 1), friction: 1, tangentSpeed: 2 } });
    // Without friction a box keeps its speed; a disc of 0.5 m at 3 m/s rolls at 6 rad/s clockwise.
    const slides = spawnAt(0, { velocity: { x: 3 }, collider: { shape: box(1, 1), density: 1, friction: 0 } });
    const rolls = spawnAt(5, {
      velocity: { x: 3 },
      angularVelocity: { z: -6 },
      collider: { shape: circle(0.5), density: 1, friction: 1 },
    });
    const carried = spawnAt(40, { collider: { shape: box(1, 1), density: 1, friction: 1 } });
    for (let i = 0; i < 60; i++) step(world, 1 / 60);
    const { count, a, b, ny, slip } = contactPoints(world);
    const slipOf = (body: number) =>
      Array.from({ length: count }, (_, i) => i)
        .filter((i) => a[i] === body || b[i] === body)
        .map((i) => slip[i]);
    expect(ny.slice(0, count).every((y) => y > 0.99)).toBe(true);
    for (const speed of slipOf(slides)) expect(speed).toBeCloseTo(3, 2);
    for (const speed of [...slipOf(rolls), ...slipOf(carried)]) expect(Math.abs(speed)).toBeLessThan(0.01);
    expect(Math.abs(world.components.Velocity.x[carried])).toBeCloseTo(2, 2);
  },
);

it('no two contacts of one colour move the same body, and contacts of bodies that sleep have none', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity({ y: -10 })], capacity: 100 });
  const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
  for (let row = 0; row < 6; row++) {
    for (let i = 0; i < 6 - row; i++) {
      const position = { x: i + row / 2, y: 0.5 + row };
      spawn(world, { position, collider: { shape: box(0.9, 1), density: 1, friction: 0.6 } });
    }
  }
  step(world, 1 / 60);
  const { count, a, b, color } = contactPoints(world);
  // Contacts with the floor, which does not move, have colours of their own.
  for (let i = 0; i < count; i++) expect(color[i] >= 20).toBe(a[i] === floor);
  const pairs = new Map<string, readonly [number, number]>();
  for (let i = 0; i < count; i++) pairs.set(`${a[i]} ${b[i]} ${color[i]}`, [a[i], b[i]]);
  // Six on the floor, and each of the others on two.
  expect(pairs.size).toBe(6 + 2 * 15);
  const moved = [...pairs].flatMap(([key, ids]) =>
    ids.filter((id) => world.components.Mass.value[id] > 0).map((id) => `${id} in ${key.split(' ')[2]}`),
  );
  expect(new Set(moved).size).toBe(moved.length);
  expect(Math.min(...color.slice(0, count))).toBe(0);
  for (let i = 0; i < 600; i++) step(world, 1 / 60);
  const asleep = contactPoints(world);
  expect(asleep.count).toBeGreaterThan(0);
  expect(new Set(asleep.color.slice(0, asleep.count))).toEqual(new Set([-1]));
});
