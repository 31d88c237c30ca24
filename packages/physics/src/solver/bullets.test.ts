// Bullets: bodies that pass through nothing, not even through what moves.
import { box, createPhysicsWorld, rigidBodies, segment, spawn, spawnCompound, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';

const DT = 1 / 60;

describe.each(['f32', 'f64'] as const)('a bullet in %s', (precision) => {
  const make = () => createPhysicsWorld({ preset: rigidBodies, forces: [], capacity: 50, precision });
  type World = ReturnType<typeof make>;
  const run = (world: World, steps: number) => {
    for (let i = 0; i < steps; i++) step(world, DT);
  };
  const shot = { radius: 0.05, density: 100, bullet: true };

  it('hits a thin door that floats, which a body that is no bullet passes', () => {
    const cross = (bullet: boolean) => {
      const world = make();
      const door = spawn(world, { position: {}, collider: { shape: box(0.05, 2), density: 100 } });
      const ball = spawn(world, { position: { x: -4.3 }, velocity: { x: 500 }, collider: { ...shot, bullet } });
      run(world, 6);
      const { Position, Velocity } = world.components;
      return [Position.x[ball] - Position.x[door], Velocity.x[door]];
    };
    const [behind, kept] = cross(false);
    expect(behind).toBeGreaterThan(1);
    expect(kept).toBe(0);
    const [before, pushed] = cross(true);
    expect(before).toBeLessThan(0);
    // They go on together or apart: momentum is conserved, and the door took some.
    expect(pushed).toBeGreaterThan(1);
  });

  it('meets another head-on, and one that crosses its way', () => {
    const world = make();
    const a = spawn(world, { position: { x: -3.1 }, velocity: { x: 400 }, collider: shot });
    const b = spawn(world, { position: { x: 3.3 }, velocity: { x: -400 }, collider: shot });
    run(world, 4);
    const { Position } = world.components;
    expect(Position.x[a]).toBeLessThan(Position.x[b]);
  });

  it('stops at a kinematic wall that turns, at sleeping bodies, and at a part of a compound', () => {
    const world = make();
    spawn(world, {
      position: {},
      angularVelocity: 0.5,
      rotation: 0,
      collider: { shape: segment({ y: -2 }, { y: 2 }) },
    });
    const first = spawn(world, { position: { x: -4 }, velocity: { x: 500 }, collider: shot });
    const plate = { shape: box(0.04, 2), density: 1000 };
    const { body } = spawnCompound(world, { position: { y: 20 }, parts: [plate, { ...plate, x: 1 }] });
    const second = spawn(world, { position: { x: 5, y: 20 }, velocity: { x: -500 }, collider: shot });
    run(world, 5);
    const { Position } = world.components;
    expect(Position.x[first]).toBeLessThan(0);
    expect(Position.x[second]).toBeGreaterThan(Position.x[body]);
  });

  it('starts anew where it is put: a teleport is no motion', () => {
    const world = make();
    const door = spawn(world, { position: {}, collider: { shape: box(0.05, 2), density: 100 } });
    const ball = spawn(world, { position: { x: -10 }, velocity: { x: 300 }, collider: shot });
    run(world, 1);
    world.components.Position.x[ball] = 10;
    run(world, 3);
    expect(world.components.Position.x[ball]).toBeCloseTo(25, 0);
    expect(world.components.Velocity.x[door]).toBe(0);
  });
});
