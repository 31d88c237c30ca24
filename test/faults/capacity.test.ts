import {
  clearFaults,
  createEmitter,
  createPhysicsWorld,
  despawn,
  on,
  type PhysicsWorld,
  spawn,
  spawnMany,
  step,
} from '@principia/physics';
import { addComponent, addEntity, removeEntity } from 'bitecs';
import { describe, expect, it, vi } from 'vitest';
import { assertRefused, assertWorldAlive, ball, DT, groundWorld, refusal, steps } from '../support/worlds.ts';

function fullWorld(capacity: number): PhysicsWorld {
  const world = groundWorld({ capacity });
  for (let i = 0; i < capacity; i++) ball(world, i, 1);
  return world;
}

const tooSmall = new WebAssembly.Memory({ initial: 1 });

const FULL = { code: 'E_CAPACITY', field: 'capacity', hint: /larger `capacity`/ };

describe('capacity', () => {
  it.each([1, 15, 16, 1023, 1024])('65 a world at its capacity of %d bodies steps', (capacity) => {
    const world = fullWorld(capacity);
    step(world, DT);
    expect([world.lastId, world.faults.faults.length]).toEqual([capacity, 0]);
    const speeds = world.components.Velocity.y.subarray(1, capacity + 1);
    expect(new Set(speeds).size).toBe(1);
    despawn(world, capacity);
    assertWorldAlive(world);
  });

  it('66 a body beyond the capacity is refused, and the world still steps', () => {
    const world = fullWorld(100);
    assertRefused(world, () => ball(world, 0, 1), FULL);
    assertRefused(world, () => spawnMany(world, 1, { position: {} }), FULL);
    step(world, DT);
    despawn(world, 50);
    assertRefused(world, () => spawnMany(world, 2, { position: {} }), FULL);
    expect(ball(world, 0, 1)).toBe(50);
    despawn(world, 7);
    assertWorldAlive(world);
  });

  it('an emitter of more particles than the capacity is refused, and told of the capacity of the world', () => {
    const world = groundWorld({ capacity: 100 });
    const hint = /capacity of the world.*larger `capacity`/;
    assertRefused(world, () => createEmitter(world, { capacity: 101 }), { code: 'E_RANGE', field: 'capacity', hint });
  });

  it('66 a raw entity beyond the capacity is refused its first component', () => {
    const world = fullWorld(100);
    const { Position } = world.components;
    const eid = addEntity(world);
    assertRefused(world, () => addComponent(world, eid, Position), { ...FULL, entity: eid });
    step(world, DT);
    removeEntity(world, eid);
    despawn(world, 3);
    assertWorldAlive(world);
  });

  it('66 freed ids beyond the capacity do not block other ids', () => {
    const world = groundWorld({ capacity: 20 });
    const raw = Array.from({ length: 40 }, () => addEntity(world));
    for (const eid of raw) removeEntity(world, eid);
    const ids = [ball(world, 0, 1), ...spawnMany(world, 10, { position: { x: 3 } }), ball(world, 1, 1)];
    expect(Math.max(...ids)).toBeLessThanOrEqual(20);
    expect(new Set(ids).size).toBe(12);
    assertRefused(world, () => spawnMany(world, 9, { position: {} }), FULL);
    spawnMany(world, 8, { position: {} });
    assertRefused(world, () => ball(world, 0, 1), FULL);
    despawn(world, ids[0]);
    assertWorldAlive(world);
  });

  it('66 during a step as well: the step completes and then throws', () => {
    const world = fullWorld(10);
    world.phases.input.push(() => ball(world, 0, 1));
    expect(() => step(world, DT)).toThrow(/E_CAPACITY/);
    world.phases.input.pop();
    expect(world.tick).toBe(1);
    despawn(world, 3);
    assertWorldAlive(world);
  });

  it('66 capacity used up by a progress callback is respected', () => {
    const world = groundWorld({ capacity: 70_000 });
    const steal = () => {
      if (world.internal.counts.Position === 0) spawnMany(world, 1000, { position: {} });
    };
    expect(refusal(() => spawnMany(world, 69_900, { angularVelocity: {} }, steal)).code).toBe('E_CAPACITY');
    expect(world.internal.counts).toMatchObject({ Position: 1000, Velocity: 0 });
    assertWorldAlive(world);
  });

  it.each([
    [
      'throws',
      () => {
        throw new RangeError('out of memory');
      },
    ],
    ['is too small', () => tooSmall],
  ])('68 memory that %s at creation gives E_CAPACITY without affecting other worlds', (_, makeMemory) => {
    const other = fullWorld(10);
    const replaced = vi.spyOn(WebAssembly, 'Memory').mockImplementation(function allocate() {
      return makeMemory();
    });
    const error = refusal(() => createPhysicsWorld());
    replaced.mockRestore();
    expect(error).toMatchObject({ code: 'E_CAPACITY', hint: /f32/ });
    despawn(other, 1);
    assertWorldAlive(other);
  });

  it('68 a world beyond the address space is refused before any allocation', () => {
    expect(refusal(() => createPhysicsWorld({ capacity: 2 ** 24 - 1 })).code).toBe('E_CAPACITY');
    expect(refusal(() => createPhysicsWorld({ capacity: 2 ** 24 })).code).toBe('E_RANGE');
  });

  it('70 unread faults are bounded, and the others are counted', () => {
    const world = groundWorld();
    const ids = spawnMany(world, 20, { position: { y: 5 }, angularVelocity: {} });
    for (let i = 0; i < 1000; i++) {
      for (const eid of ids) world.components.AngularVelocity.z[eid] = 1e30;
      step(world, DT);
    }
    const { faults } = world;
    expect([faults.faults.length, faults.droppedCount]).toEqual([1024, 20_000 - 1024]);
    expect(world.internal.stepFaults.length).toBe(20);
    clearFaults(faults);
    expect(world.faults).toMatchObject({ faults: [], droppedCount: 0 });
    assertWorldAlive(world);
  });

  it('70 handlers receive every fault, even if the log is full', () => {
    const world = groundWorld();
    const eid = spawn(world, { position: { y: 5 }, angularVelocity: {} });
    let heard = 0;
    on(world, 'fault', () => {
      heard++;
    });
    for (let i = 0; i < 1500; i++) {
      world.components.AngularVelocity.z[eid] = 1e30;
      step(world, DT);
    }
    expect([heard, world.faults.droppedCount]).toEqual([1500, 476]);
  });

  it('70 memory does not grow in a hundred thousand steps', () => {
    const world = groundWorld({ capacity: 20 });
    ball(world, 0, 1, { x: 1 });
    steps(world, 100_000);
    const { edits, thrown, stepFaults } = world.internal;
    const { deferred, pending, departed, leaving } = edits;
    expect([deferred.length, thrown.length, stepFaults.length]).toEqual([0, 0, 0]);
    expect([pending.size, departed.size, leaving.size]).toEqual([0, 0, 0]);
    expect([world.tick, world.faults.faults.length]).toEqual([100_000, 0]);
  });
});
