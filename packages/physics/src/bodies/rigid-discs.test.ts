// A disc among rigid bodies turns as a box does, whatever its mass is given by.
import { box, createJoint, createPhysicsWorld, revolute, spawn, spawnMany, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { G, rigidWorld } from '../../../../test/support/rigid-world.ts';

it.each([
  { mass: 2, collider: { radius: 0.3 } },
  { mass: 2, collider: 0.3 },
  { mass: { value: 2 }, collider: { radius: 0.3 }, rotation: 1 },
  { collider: { radius: 0.3, density: 2 / (Math.PI * 0.09) } },
])('has the inertia m r²/2 and swings about its rim with it: %j', (body) => {
  const world = rigidWorld();
  const id = spawn(world, { position: {}, ...body });
  expect(world.components.Inertia.value[id]).toBeCloseTo(0.09, 12);
  createJoint(world, revolute({ b: id, anchor: { x: -0.3, y: 0 } }));
  step(world, 1e-3);
  // m g r/(m r²/2 + m r²), less what a hinge to the world gives way, a ten-thousandth.
  const acceleration = G / 0.45;
  expect(Math.abs((world.components.AngularVelocity.z[id] as number) / -1e-3 / acceleration - 1)).toBeLessThan(1e-3);
});

it('keeps an inertia that is given, and turns', () => {
  const world = rigidWorld();
  const id = spawn(world, {
    position: {},
    mass: 1,
    inertia: 0.4,
    angularVelocity: { z: 2 },
    collider: { radius: 0.5 },
  });
  step(world, 0.5);
  expect(world.components.Inertia.value[id]).toBe(0.4);
  expect(world.components.Rotation.angle[id]).toBeCloseTo(1, 12);
});

it('has by the thousand the inertia of its own mass and radius', () => {
  const world = rigidWorld();
  const ids = spawnMany(world, 2, { position: { x: [0, 5] }, mass: [1, 2], collider: { radius: [0.5, 1] } });
  expect(Array.from(ids, (id) => world.components.Inertia.value[id])).toEqual([0.125, 1]);
});

it('stays a point that does not turn in worlds of particles', () => {
  const world = createPhysicsWorld();
  const id = spawn(world, { position: {}, mass: 1, collider: { radius: 0.5 } });
  expect(world.components.Inertia.value[id]).toBe(0);
});

it('says where density and mass stand, when one is not where it belongs', () => {
  const world = rigidWorld();
  const body = { position: {}, collider: { radius: 0.5, mass: 3 } };
  expect(() => spawn(world, body)).toThrow(/no field "mass".*In spawn also density; mass stands beside collider/);
  const shape = box(1, 1);
  expect(() => spawn(world, { position: {}, collider: shape as never })).toThrow(/a shape in it: { shape: box/);
  const both = spawn(world, { position: {}, mass: 3, collider: { radius: 0.5, density: 100 } });
  expect(world.components.Mass.value[both]).toBe(3);
});
