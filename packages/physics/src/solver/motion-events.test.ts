// Which bodies moved, fell asleep and woke: each once, and the same after a restore.
import {
  box,
  createPhysicsWorld,
  motionEvents,
  restore,
  rigidBodies,
  snapshot,
  spawn,
  spawnCompound,
  step,
  uniformGravity,
  wake,
} from '@principia/physics';
import { expect, test } from 'vitest';

function record(world: ReturnType<typeof createPhysicsWorld>, steps: number): string[] {
  const { moved, asleep, awake } = motionEvents(world);
  const ids = ({ ids: list, count }: typeof moved) => [...list.subarray(0, count)];
  return Array.from({ length: steps }, () => {
    step(world, 1 / 60);
    return JSON.stringify([ids(moved), ids(asleep), ids(awake)]);
  });
}

test('bodies move until they fall asleep, and again when they wake', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 50 });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
  const crate = { shape: box(1, 1), density: 1, friction: 0.6 };
  const low = spawn(world, { position: { y: 0.5 }, collider: crate });
  const high = spawn(world, { position: { y: 1.5 }, collider: crate });
  const { body } = spawnCompound(world, { position: { x: 5, y: 0.5 }, parts: [crate, { ...crate, x: 1 }] });
  const kept = snapshot(world);
  const steps = record(world, 120);
  const all = [low, high, body];
  expect(JSON.parse(steps[0])).toEqual([all, [], []]);
  const slept = steps.flatMap((text) => JSON.parse(text)[1]).sort((a: number, b: number) => a - b);
  expect(slept).toEqual(all);
  expect(JSON.parse(steps[119])).toEqual([[], [], []]);
  wake(world, high);
  const [woken] = record(world, 1);
  expect(JSON.parse(woken)).toEqual([[low, high], [], expect.arrayContaining([low, high])]);
  restore(world, kept);
  expect(record(world, 120)).toEqual(steps);
});
