// A body that takes the place and the id of one that is gone collides from its first step on.
import { box, contactEvents, despawn, type PhysicsWorld, sensorEvents, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

const floor = (world: PhysicsWorld) => spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1) } });
const crate = (world: PhysicsWorld) =>
  spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('a crate rests where another was, and their contacts end and begin', () => {
    const world = rigidWorld({ precision });
    floor(world);
    const first = crate(world);
    run(world, 1);
    despawn(world, first);
    expect(crate(world)).toBe(first);
    step(world, DT);
    const { begin, end } = contactEvents(world);
    expect([begin.count, end.count]).toEqual([1, 1]);
    run(world, 1);
    expect(Math.abs(world.components.Position.y[first] - 0.5)).toBeLessThan(SLOP);
  });

  it('what lies on a floor that is replaced does not fall', () => {
    const world = rigidWorld({ precision });
    const ground = floor(world);
    const id = crate(world);
    run(world, 0.3); // it is awake
    despawn(world, ground);
    expect(floor(world)).toBe(ground);
    for (let i = 0; i < 60; i++) {
      step(world, DT);
      expect(world.components.Position.y[id]).toBeGreaterThan(0.5 - SLOP);
    }
  });

  it('a sensor that is replaced reports what stands in it', () => {
    const world = rigidWorld({ precision });
    floor(world);
    crate(world);
    const coin = () => spawn(world, { position: { y: 0.5 }, collider: { radius: 0.2, sensor: true } });
    const first = coin();
    run(world, 1);
    despawn(world, first);
    expect(coin()).toBe(first);
    step(world, DT);
    const { begin, end } = sensorEvents(world);
    expect([begin.count, end.count]).toEqual([1, 1]);
  });

  it('a foot that is attached to another body carries it', () => {
    const world = rigidWorld({ precision });
    floor(world);
    const body = (x: number) => spawn(world, { position: { x, y: 1.2 }, mass: 1, collider: { shape: box(0.4, 0.4) } });
    const [left, right] = [body(-0.2), body(0.2)];
    const foot = spawn(world, {
      position: {},
      rotation: 0,
      collider: { shape: box(0.4, 1) },
      attachment: { body: left, y: -0.7 },
    });
    run(world, 1);
    const { Attachment, Position } = world.components;
    Attachment.body[foot] = right;
    Position.x[right] = Position.x[left];
    Position.y[right] = Position.y[left];
    Position.x[left] = 5;
    for (let i = 0; i < 60; i++) {
      step(world, DT);
      expect(Position.y[right]).toBeGreaterThan(1.2 - SLOP);
    }
    expect(Math.abs(Position.y[left] - 0.2)).toBeLessThan(SLOP);
  });
});
