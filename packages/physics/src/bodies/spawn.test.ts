import { inspect } from 'node:util';
import { addComponent, addEntity, hasComponent, set } from 'bitecs';
import { expect, it } from 'vitest';
import { chain } from '../collision/shapes/2d/chain.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { rigidBodies } from '../presets/rigid-bodies.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { spawn } from './spawn.ts';
import { spawnMany } from './spawn-many.ts';

it('a body spawned with mass and no velocity falls from rest', () => {
  const world = createPhysicsWorld({ forces: [uniformGravity({ y: -10 })] });
  const one = spawn(world, { position: { y: 5 }, mass: 2 });
  const [first] = spawnMany(world, 1, { position: { y: 5 }, mass: 2 });
  step(world, 0.5);
  // Velocity Verlet is exact for constant force: 5 − 10 · 0.5² / 2.
  expect(world.components.Position.y[one]).toBe(3.75);
  expect(world.components.Position.y[first as number]).toBe(3.75);
});

it('components added manually and bodies without mass get no additional components', () => {
  const world = createPhysicsWorld();
  const { Position, Mass, Velocity } = world.components;
  const byHand = addEntity(world);
  addComponent(world, byHand, set(Position, {}));
  addComponent(world, byHand, set(Mass, 1));
  const anchor = spawn(world, { position: {} });
  expect(hasComponent(world, byHand, Velocity)).toBe(false);
  expect(hasComponent(world, anchor, Velocity)).toBe(false);
});

it('segments of a chain in place of a shape are refused, and the error prints in few lines', () => {
  const world = createPhysicsWorld({ preset: rigidBodies });
  const shape = chain([{ x: 2 }, { x: 1 }, { x: 0 }]) as never;
  let thrown: unknown;
  try {
    spawn(world, { position: {}, collider: { shape } });
  } catch (error) {
    thrown = error;
  }
  expect(thrown).toMatchObject({ code: 'E_TYPE', field: 'collider.shape', value: shape });
  expect((thrown as Error).message).toMatch(/must be one shape, got an array\..*spawnChain/);
  expect(inspect(thrown)).not.toContain('vertices');
});
