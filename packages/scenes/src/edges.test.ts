import { bodies, createPhysicsWorld, type GlobalSystem, spawn, step, uniformGravity } from '@principia/physics';
import { expect, it } from 'vitest';
import { isOutside, relaunchOutside, removeOutside, wrapAround } from './edges.ts';
import { teleport } from './teleport.ts';

const REGION = { min: { x: -1, y: 0 }, max: { x: 3, y: 10 } };

function moving(
  rule: GlobalSystem,
  phase: 'input' | 'finish' = 'input',
  velocity: { x?: number; y?: number } = { x: 1 },
) {
  const world = createPhysicsWorld({ capacity: 9 });
  const id = spawn(world, { position: { y: 5 }, velocity, mass: 1 });
  world.phases[phase].push(rule);
  return { world, id, x: world.components.Position.x, y: world.components.Position.y };
}

it('brings bodies back at the opposite side, with their velocity and their way within the step', () => {
  for (const phase of ['input', 'finish'] as const) {
    const { world, id, x } = moving(wrapAround({ min: { x: -1 }, max: { x: 3 } }), phase);
    for (let i = 0; i < 40; i++) step(world, 0.25);
    // 10 m on a ring of 4 m, from 0.
    expect(x[id]).toBe(2);
    expect(world.components.Velocity.x[id]).toBe(1);
    expect(world.previous.Position.x[id]).toBe(1.75);
  }
});

it('leaves bodies at a side where they are, and open axes open', () => {
  const { world, id, x, y } = moving(wrapAround({ min: { x: -1 }, max: { x: 3 } }), 'finish', { x: 1, y: 100 });
  for (let i = 0; i < 3; i++) step(world, 1);
  expect([x[id], y[id]]).toEqual([3, 305]);
  step(world, 1);
  expect([x[id], y[id]]).toEqual([0, 405]);
});

it('counts the rounds of a body that is faster than the ring is long', () => {
  for (const [speed, at] of [
    [9, 1],
    [-9, -1],
    [-10, 2],
  ]) {
    const { world, id, x } = moving(wrapAround({ min: { x: -1 }, max: { x: 3 } }), 'finish', { x: speed });
    step(world, 1);
    expect(x[id]).toBe(at);
  }
});

it('concerns only the bodies that it is given', () => {
  const { world, id, x } = moving(wrapAround({ min: { x: -1 }, max: { x: 3 } }, []));
  for (let i = 0; i < 10; i++) step(world, 1);
  expect(x[id]).toBe(10);
});

it('refuses a ring without length', () => {
  expect(() => wrapAround({ max: { x: 3 } })).toThrow('the sides along x are -Infinity and 3');
  expect(() => wrapAround({ min: { y: 3 }, max: { y: 3 } })).toThrow('the sides along y are 3 and 3');
  expect(() => wrapAround({ min: { y: Number.NaN }, max: { y: 3 } })).toThrow('the sides along y are NaN and 3');
});

it('launches again what has left', () => {
  const launched: number[] = [];
  const { world, id, x } = moving((now, dt) => rule(now, dt));
  const rule = relaunchOutside(REGION, [id], (left, index) => {
    launched.push(index);
    teleport(world, left, { x: 0, y: 5 }, { x: 2, y: 0 });
  });
  for (let i = 0; i < 4; i++) step(world, 1);
  expect([x[id], launched, isOutside(world, id, REGION)]).toEqual([4, [], true]);
  step(world, 1);
  expect([x[id], launched]).toEqual([2, [0]]);
});

it('removes what has left, and nothing else', () => {
  const world = createPhysicsWorld({ capacity: 9, forces: [uniformGravity({ y: -2 })] });
  const [high, , low] = [4, 5, 1].map((y) => spawn(world, { position: { y }, velocity: {}, mass: 1 }));
  world.phases.input.push(removeOutside({ min: { y: 0 } }));
  for (let i = 0; i < 3; i++) step(world, 1);
  // After two seconds they have fallen 4 m: the lowest is below, the first exactly at the side.
  expect(Array.from(bodies(world).ids.subarray(0, bodies(world).count))).toEqual([high, high + 1]);
  expect(low).toBe(high + 2);
});
