// Bodies that are put into what does not move, from more than one side, are pushed out without being thrown.
import { box, capsule, energy, type PhysicsWorld, polygon, type Shape, spawn, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** A plank of 2.3 m that does not move. */
const plank = (world: PhysicsWorld, x: number, y: number, rotation: number) =>
  spawn(world, { position: { x, y }, rotation, collider: { shape: box(2.3, 0.3), friction: 0.5 } });

const PLACES: Record<string, (world: PhysicsWorld) => void> = {
  'crossing planks': (world) => {
    plank(world, 0.1, 0, 0.77);
    plank(world, -0.2, 0.14, 0.03);
  },
  'a slot of 0.4 m': (world) => {
    plank(world, -0.35, 0, Math.PI / 2);
    plank(world, 0.35, 0, Math.PI / 2);
  },
  'a funnel': (world) => {
    plank(world, -0.7, 0.5, -1);
    plank(world, 0.7, 0.5, 1);
  },
};

const SHAPES: Record<string, Shape> = {
  box: box(0.8, 0.5),
  capsule: capsule(0.6, 0.25),
  triangle: polygon([{ x: -0.4, y: -0.3 }, { x: 0.4, y: -0.3 }, { y: 0.5 }]),
};

const CASES = Object.keys(PLACES).flatMap((place) => Object.keys(SHAPES).map((shape) => [shape, place] as const));

// Overlap is pushed out at 3 m/s, of which relaxing may leave a third: half of (1 m/s)² for each kilogram.
test.each(CASES)('a %s at rest in %s keeps no speed of its push, without gravity', (shape, place) => {
  for (let k = 0; k < 40; k++) {
    const world = rigidWorld({ forces: [] });
    PLACES[place](world);
    const position = { x: 0.2 * Math.sin(3 * k), y: 0.2 * Math.cos(5 * k) };
    spawn(world, { position, rotation: 0.4 * k, mass: 1, collider: { shape: SHAPES[shape], friction: 0.5 } });
    for (let i = 0; i < 90; i++) {
      step(world, DT);
      expect(energy(world).kinetic).toBeLessThan(0.5);
    }
  }
});

test('a body put into a corner of the ground comes out, and a pile that it touches keeps its energy', () => {
  const world = rigidWorld();
  spawn(world, { position: { y: -1 }, collider: { shape: box(20, 2), friction: 0.5 } });
  spawn(world, { position: { x: -2 }, collider: { shape: box(2, 6), friction: 0.5 } });
  const crate = { shape: box(0.5, 0.5), friction: 0.5 };
  for (let i = 0; i < 12; i++)
    spawn(world, { position: { x: 0.3 + 0.5 * (i % 3), y: 0.25 + 0.5 * Math.floor(i / 3) }, mass: 1, collider: crate });
  for (let i = 0; i < 60; i++) step(world, DT);
  const before = energy(world).total;
  const wedged = spawn(world, { position: { x: -0.95, y: 0.05 }, rotation: 0.3, mass: 1, collider: crate });
  const { Position } = world.components;
  for (let i = 0; i < 240; i++) {
    step(world, DT);
    // What is lifted out of the corner rises by its own size at most: m g 0.5 m.
    expect(energy(world).total - before).toBeLessThan(0.5 * 9.81 + 0.5);
  }
  expect(Position.x[wedged]).toBeGreaterThan(-0.76);
  expect(Position.y[wedged]).toBeGreaterThan(0.24);
});
