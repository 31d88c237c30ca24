// A straight bridge of planks between two piers: without sag its tension is as large as its joints let it be.
import {
  box,
  capsule,
  createJoint,
  createPhysicsWorld,
  revolute,
  rigidBodies,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, test } from 'vitest';

const PLANK = 0.5;

/** The height of the lowest plank below the piers, m, after each second. */
function sags(precision: 'f32' | 'f64', planks: number, load: number): number[] {
  const forces = [uniformGravity({ y: -9.81 })];
  const world = createPhysicsWorld({ preset: rigidBodies, forces, capacity: 400, precision });
  const half = (PLANK * planks) / 2;
  const pier = (side: number) =>
    spawn(world, { position: { x: side * (half + 0.5) }, collider: { shape: box(1, 0.25) } });
  const piers = [pier(-1), pier(1)];
  const ids: number[] = [];
  for (let i = 0; i <= planks; i++) {
    const x = PLANK * i - half;
    const collider = { shape: box(PLANK, 0.25), density: 1, friction: 0.6 };
    const next = i === planks ? piers[1] : spawn(world, { position: { x: x + PLANK / 2 }, rotation: 0, collider });
    createJoint(world, revolute({ a: ids.at(-1) ?? piers[0], b: next, anchor: { x, y: 0 } }));
    if (i < planks) ids.push(next);
  }
  for (let i = 0; i < load; i++) {
    const shape = i % 2 === 0 ? capsule(0.5, 0.2) : box(0.5, 0.5);
    const position = { x: 0.7 * ((i % 20) - 9.5), y: 0.43 + 0.6 * Math.floor(i / 20) };
    spawn(world, { position, rotation: 0, collider: { shape, density: 1, friction: 0.6 } });
  }
  return Array.from({ length: 4 }, () => {
    for (let i = 0; i < 60; i++) step(world, 1 / 60);
    return -Math.min(...ids.map((id) => world.components.Position.y[id]));
  });
}

test.each([
  ['f64', 45, 20],
  ['f64', 60, 40],
  ['f64', 120, 30],
  ['f32', 45, 45],
  ['f32', 120, 30],
] as const)('bears what falls on it, %s, %d planks, %d bodies', (precision, planks, load) => {
  const [, , third, last] = sags(precision, planks, load);
  // A hundredth of its span, and at rest to a hundredth of that.
  expect(last).toBeLessThan(0.01 * PLANK * planks);
  expect(Math.abs(last - third)).toBeLessThan(1e-4 * PLANK * planks);
});
