// What queries find is a place for all that wants one.
import { expect, test } from 'vitest';
import {
  applyImpulse,
  bodyAt,
  box,
  castShape,
  circle,
  createJoint,
  createPhysicsWorld,
  distance,
  explode,
  type Hit,
  jointPosition,
  nearestPoint,
  rayCast,
  revolute,
  rigidBodies,
  spawn,
} from '../index.ts';

function room() {
  const world = createPhysicsWorld({ preset: rigidBodies });
  const block = spawn(world, { position: { x: 3 }, mass: Infinity, collider: { shape: box(2, 2) } });
  const player = spawn(world, { position: {}, collider: { shape: circle(0.3), density: 100 } });
  const hit = rayCast(world, {}, { x: 9 }, { ignore: player }) as Hit;
  return { world, block, player, hit };
}

test('joints are tied to it', () => {
  const { world, block, player, hit } = room();
  const hook = distance({ a: hit.body, b: player, anchorA: hit, motor: { speed: -1, max: 1000 } });
  expect(jointPosition(world, createJoint(world, hook))).toBe(2);
  const met = castShape(world, circle(0.5), { y: 0 }, { x: 9 }, { ignore: player }) as Hit;
  expect(createJoint(world, revolute({ a: block, b: player, anchor: met }))).toBeGreaterThan(0);
  const near = nearestPoint(world, { y: 5 }, { ignore: player });
  expect(() => distance({ b: player, anchorA: near as { x: number; y: number } })).not.toThrow();
});

test('rays start from it, bodies are looked for there, and it is the centre of explosions and impulses', () => {
  const { world, block, player, hit } = room();
  expect(rayCast(world, { x: 3, y: 9 }, hit)?.body).toBe(block);
  expect(nearestPoint(world, hit)).toMatchObject({ body: block, distance: 0 });
  expect(bodyAt(world, hit)).toBe(block);
  explode(world, { centre: hit, impulse: 10, radius: 4 });
  const { x } = world.components.Velocity;
  expect(x[player]).toBeLessThan(0);
  const { z } = world.components.AngularVelocity;
  applyImpulse(world, player, { y: 1 }, hit);
  expect(z[player]).toBeGreaterThan(0);
});

test('it is no velocity and no direction, and other names of axes are refused', () => {
  const { world, player, hit } = room();
  expect(() => applyImpulse(world, player, hit)).toThrow(/E_UNKNOWN.*impulse has no axis "body"/s);
  const misspelt = { x: 1, Y: 2 };
  expect(() => distance({ b: player, anchorA: misspelt })).toThrow(/E_UNKNOWN.*anchorA has no axis "Y"/s);
  expect(() => rayCast(world, {}, { ...hit, x: Number.NaN })).toThrow(/E_NONFINITE/);
});
