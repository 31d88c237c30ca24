import {
  box,
  createPhysicsWorld,
  despawn,
  restore,
  rigidBodies,
  snapshot,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, it } from 'vitest';
import { dragByJoints } from './joint-dragging.ts';

const DT = 1 / 60;

function worldWithBox(capacity = 20) {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity, forces: [uniformGravity()] });
  const crate = spawn(world, { position: {}, collider: { shape: box(1, 1), density: 2 } });
  return { world, crate, dragging: dragByJoints(world) };
}

function run(world: ReturnType<typeof worldWithBox>['world'], seconds: number) {
  for (let i = 0; i < seconds / DT; i++) step(world, DT);
}

it('lets a body hang from the point at which it was grabbed, and turn about it', () => {
  const { world, crate, dragging } = worldWithBox();
  dragging.grab(1, crate, 0.5, 0.5);
  expect(dragging.dragged).toEqual([crate]);
  dragging.move(1, 3, 4);
  // Without friction it would swing for ever; a pointer that is held still does not let it drop.
  run(world, 3);
  const { Position } = world.components;
  const [dx, dy] = [Position.x[crate] - 3, Position.y[crate] - 4];
  // The spring of 8 Hz gives way by g/(2 π f)², 4 mm, at rest, and by several times that while the body swings.
  expect(Math.abs(Math.hypot(dx, dy) - Math.hypot(0.5, 0.5))).toBeLessThan(0.03);
  expect(dy).toBeLessThan(0.72);
});

it('throws a body with the speed that it has', () => {
  const { world, crate, dragging } = worldWithBox();
  dragging.grab(1, crate, 0, 0);
  for (let i = 1; i <= 30; i++) {
    dragging.move(1, 0.1 * i, 0);
    step(world, DT);
  }
  dragging.release(1, 0, 0);
  expect(dragging.dragged).toEqual([]);
  expect(world.components.Velocity.x[crate]).toBeGreaterThan(5);
  expect(world.components.Velocity.x[crate]).toBeLessThan(7);
  const { x } = world.components.Velocity;
  const speed = x[crate];
  run(world, 0.5);
  expect(x[crate]).toBeCloseTo(speed, 3);
});

it('moves a body to its pointer without a step, survives its end, and what has no mass stays', () => {
  const { world, crate, dragging } = worldWithBox();
  const ground = spawn(world, { position: { y: -5 }, collider: { shape: box(9, 1) } });
  dragging.grab(1, ground, 0, -5);
  expect(dragging.dragged).toEqual([]);
  dragging.grab(1, crate, 0.25, 0);
  dragging.move(1, 2, 3);
  dragging.place();
  expect(world.components.Position.x[crate]).toBeCloseTo(1.75, 6);
  despawn(world, crate);
  run(world, 0.1);
  dragging.move(1, 5, 5);
  dragging.release(1, 0, 0);
  dragging.releaseAll();
});

it('comes back with a snapshot, joint and all', () => {
  const { world, crate, dragging } = worldWithBox();
  dragging.grab(1, crate, 0, 0);
  const taken = snapshot(world);
  dragging.dropAll();
  run(world, 0.5);
  restore(world, taken);
  expect(dragging.dragged).toEqual([crate]);
  run(world, 1);
  expect(Math.abs(world.components.Position.y[crate])).toBeLessThan(0.05);
});

it('leaves a full world as it is', () => {
  const { crate, dragging } = worldWithBox(1);
  dragging.grab(1, crate, 0, 0);
  expect(dragging.dragged).toEqual([]);
});
