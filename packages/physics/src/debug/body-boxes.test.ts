import { bodyBoxes, box, createJoint, despawn, distance, spawn, spawnCompound, wake } from '@principia/physics';
import { expect, it } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

it.each(['f32', 'f64'] as const)(
  'the boxes of bodies hold their shapes and a margin, and tell who sleeps, %s',
  (precision) => {
    const world = rigidWorld({ precision });
    const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
    const ghost = spawn(world, { position: { x: 9 } });
    const crate = spawn(world, { position: { x: 3, y: 0.5 }, collider: { shape: box(1, 1), density: 2 } });
    const list = bodyBoxes(world);
    expect(list.count).toBe(0);
    run(world, 1);
    expect(bodyBoxes(world, list)).toBe(list);
    expect(list.body.slice(0, list.count)).toEqual([floor, crate]);
    expect(list.body).not.toContain(ghost);
    // The margin is the smaller of 5 cm and an eighth of the extent.
    const margin = Math.min(0.05, Math.SQRT1_2 / 8);
    for (const [side, edge] of [
      [list.minX[1], 2.5 - margin],
      [list.maxX[1], 3.5 + margin],
      [list.minY[1], -margin],
      [list.maxY[1], 1 + margin],
    ]) {
      expect(Math.abs(side - edge)).toBeLessThan(0.005);
    }
    expect(list.asleep).toEqual([false, true]);
    wake(world, crate);
    run(world, 1 / 60);
    expect(bodyBoxes(world, list).asleep[1]).toBe(false);
    expect(() => bodyBoxes(world, {} as never)).toThrow(/E_TYPE.*a list made by bodyBoxes/);
  },
);

it.each(['f32', 'f64'] as const)('islands are bodies that touch or are joined, awake and asleep, %s', (precision) => {
  const world = rigidWorld({ precision });
  const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
  const crateAt = (x: number, y: number) =>
    spawn(world, { position: { x, y }, collider: { shape: box(1, 1), density: 2, friction: 0.6 } });
  const stack = [crateAt(0, 0.5), crateAt(0, 1.5), crateAt(0, 2.5)];
  const alone = crateAt(4, 0.5);
  const [left, right] = [crateAt(8, 0.5), crateAt(11, 0.5)];
  const rod = createJoint(
    world,
    distance({ a: left, b: right, anchorA: { x: 8, y: 0.5 }, anchorB: { x: 11, y: 0.5 } }),
  );
  const pair = spawnCompound(world, {
    position: { x: -5, y: 0.5 },
    parts: [
      { shape: box(1, 1), density: 1 },
      { shape: box(1, 1), x: 1, density: 1 },
    ],
  });
  const islands = () => {
    const { body, island, count } = bodyBoxes(world);
    return new Map(body.slice(0, count).map((id, i) => [id, island[i]]));
  };
  for (const seconds of [0.1, 3]) {
    run(world, seconds);
    const found = islands();
    expect(found.get(floor)).toBe(0);
    expect(stack.map((id) => found.get(id))).toEqual([stack[0], stack[0], stack[0]]);
    expect(found.get(alone)).toBe(alone);
    expect([found.get(left), found.get(right)]).toEqual([left, left]);
    expect(pair.parts.map((id) => found.get(id))).toEqual([pair.body, pair.body]);
  }
  expect(bodyBoxes(world).asleep.filter((each) => each).length).toBeGreaterThan(5);
  despawn(world, rod);
  wake(world, left);
  run(world, 0.1);
  expect([islands().get(left), islands().get(right)]).toEqual([left, right]);
});
