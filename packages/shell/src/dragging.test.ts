import { createPhysicsWorld, despawn, type PhysicsWorld, spawn, step, uniformGravity } from '@principia/physics';
import { expect, it } from 'vitest';
import { dragBodies } from './dragging.ts';

const DT = 1 / 60;

function worldWithBalls(dimensions: 2 | 3 = 2): { world: PhysicsWorld; a: number; b: number } {
  const world = createPhysicsWorld({ dimensions, capacity: 10, forces: [uniformGravity()] });
  const a = spawn(world, { position: { x: 1, y: 2 }, velocity: { x: 3 }, mass: 1 });
  const b = spawn(world, { position: { x: -1, y: 2 }, velocity: {}, mass: 5 });
  return { world, a, b };
}

it('brings bodies to their pointers within a step, each to its own', () => {
  const { world, a, b } = worldWithBalls();
  const dragging = dragBodies(world);
  const { x, y } = world.components.Position;
  dragging.grab(7, a, 1.1, 2.2);
  dragging.grab(9, b, -1, 2);
  expect(dragging.dragged).toEqual([a, b]);
  dragging.move(7, 1.5, 2.4);
  dragging.move(9, -1.25, 1.75);
  step(world, DT);
  expect([x[a], x[b]]).toEqual([expect.closeTo(1.4, 12), expect.closeTo(-1.25, 12)]);
  expect([y[a], y[b]]).toEqual([expect.closeTo(2.2, 12), expect.closeTo(1.75, 12)]);
  for (let i = 0; i < 100; i++) step(world, DT);
  expect([x[a], y[a]]).toEqual([expect.closeTo(1.4, 12), expect.closeTo(2.2, 12)]);
});

it('throws with the given velocity, at most the highest', () => {
  const { world, a, b } = worldWithBalls();
  const dragging = dragBodies(world, { maxSpeed: 10 });
  const { Velocity } = world.components;
  dragging.grab(1, a, 1, 2);
  dragging.release(1, 4, -3);
  expect([Velocity.x[a], Velocity.y[a]]).toEqual([4, -3]);
  dragging.grab(1, b, -1, 2);
  dragging.release(1, 60, 80);
  expect([Velocity.x[b], Velocity.y[b]]).toEqual([6, 8]);
  expect(dragging.dragged).toEqual([]);
  dragging.release(1, 1, 1);
  dragging.move(1, 1, 1);
});

it('has a third dimension where the world has one', () => {
  const { world, a } = worldWithBalls(3);
  const dragging = dragBodies(world);
  dragging.grab(1, a, 1, 2, 0.5);
  dragging.move(1, 1, 2, 1);
  step(world, DT);
  expect(world.components.Position.z[a]).toBeCloseTo(0.5, 12);
  dragging.release(1, 0, 0, 2);
  expect(world.components.Velocity.z[a]).toBe(2);
});

it('keeps bodies where a limit wants them, and moves them without a step too', () => {
  const { world, a } = worldWithBalls();
  const dragging = dragBodies(world, {
    limit(point) {
      point.x = Math.min(point.x, 2);
    },
  });
  dragging.grab(1, a, 1, 2);
  dragging.move(1, 5, 3);
  const { pose } = world.versions;
  dragging.place();
  expect([world.components.Position.x[a], world.components.Position.y[a], world.previous.Position.x[a]]).toEqual([
    2, 3, 2,
  ]);
  expect(world.versions.pose).toBe(pose + 1);
});

it('gives the mass back, also after a second finger on the same body', () => {
  const { world, a, b } = worldWithBalls();
  const dragging = dragBodies(world);
  const { Mass, Position } = world.components;
  dragging.grab(1, b, -1, 2);
  dragging.grab(2, b, -1, 2);
  expect([dragging.dragged, Mass.value[b], Mass.value[a]]).toEqual([[b], 0, 1]);
  dragging.release(2, 9, 9);
  expect(dragging.dragged).toEqual([b]);
  dragging.release(1, 0, 0);
  expect(Mass.value[b]).toBe(5);
  step(world, 1);
  expect(Position.y[b]).toBeCloseTo(2 - 9.80665 / 2, 12);
});

it('leaves a body alone that has got the id of one that was held', () => {
  const { world, a } = worldWithBalls();
  const dragging = dragBodies(world);
  dragging.grab(1, a, 1, 2);
  despawn(world, a);
  const next = spawn(world, { position: { x: 4 }, velocity: {}, mass: 2 });
  expect(next).toBe(a);
  dragging.release(1, 7, 7);
  expect([world.components.Mass.value[next], world.components.Velocity.x[next]]).toEqual([2, 0]);
});

it('forgets a body that is gone', () => {
  const { world, a, b } = worldWithBalls();
  const dragging = dragBodies(world);
  dragging.grab(1, a, 1, 2);
  dragging.grab(2, b, -1, 2);
  despawn(world, a);
  dragging.place();
  step(world, DT);
  expect(dragging.dragged).toEqual([b]);
  dragging.releaseAll();
  expect(dragging.dragged).toEqual([]);
  expect(world.faults.faults).toEqual([]);
});

it('holds several bodies by one pointer, as they lie, and lets go of all', () => {
  const { world, a, b } = worldWithBalls();
  const dragging = dragBodies(world);
  const { Position, Velocity, Mass } = world.components;
  dragging.grab(1, a, 0, 2);
  dragging.grab(1, b, 0, 2);
  dragging.move(1, 0.5, 2);
  step(world, DT);
  expect([Position.x[a], Position.x[b]]).toEqual([expect.closeTo(1.5, 12), expect.closeTo(-0.5, 12)]);
  dragging.release(1, 2, 0);
  expect([dragging.dragged, Mass.value[a], Mass.value[b]]).toEqual([[], 1, 5]);
  expect([Velocity.x[a], Velocity.x[b]]).toEqual([2, 2]);
});

it('puts down what has infinite mass, where others are thrown', () => {
  const { world, a } = worldWithBalls();
  const { Position, Velocity, Mass } = world.components;
  Mass.value[a] = Infinity;
  const dragging = dragBodies(world);
  dragging.grab(1, a, 1, 2);
  dragging.move(1, 3, 2);
  step(world, DT);
  dragging.release(1, 9, 9);
  step(world, DT);
  expect([Mass.value[a], Position.x[a], Velocity.x[a]]).toEqual([Infinity, expect.closeTo(1 + 50 * DT, 12), 0]);
});
