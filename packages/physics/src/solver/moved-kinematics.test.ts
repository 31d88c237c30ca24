// A kinematic body that is moved by its Position counts as moved, whatever else wakes in the same step.
import { box, createJoint, isAsleep, type PhysicsWorld, revolute, sensorEvents, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const unit = { shape: box(1, 1), density: 10 };

/** A crate that sleeps far away, and what wakes it from above within a step. */
function addSleeper(world: PhysicsWorld): () => void {
  spawn(world, { position: { x: 20, y: -0.5 }, collider: { shape: box(20, 1) } });
  const crate = spawn(world, { position: { x: 20, y: 0.5 }, collider: unit });
  const press = spawn(world, { position: { x: 20, y: 1.6 }, velocity: {}, kinematic: {}, collider: unit });
  return () => {
    expect(isAsleep(world, crate)).toBe(true);
    world.components.Position.y[press] -= 0.11;
  };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('what hangs from it and sleeps goes with it', () => {
    const world = rigidWorld({ precision });
    const { Position } = world.components;
    const hook = spawn(world, { position: { y: 10 }, velocity: {}, kinematic: {}, collider: { shape: box(0.2, 0.2) } });
    const load = spawn(world, { position: { y: 8 }, collider: unit });
    createJoint(world, revolute({ a: hook, b: load, anchor: { y: 10 } }));
    const wakeOther = addSleeper(world);
    run(world, 3);
    expect(isAsleep(world, load)).toBe(true);
    Position.y[hook] += 0.5;
    wakeOther();
    run(world, 2);
    expect(Position.y[load]).toBeCloseTo(8.5, 2);
  });

  it('a sensor that it leaves says so', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: 10 }, collider: { shape: box(2, 2), sensor: true } });
    const guest = spawn(world, { position: { x: 1.1, y: 10 }, velocity: {}, kinematic: {}, collider: { radius: 0.2 } });
    const wakeOther = addSleeper(world);
    run(world, 3);
    // Out of the sensor, though the boxes about the two overlap yet.
    world.components.Position.x[guest] = 1.23;
    wakeOther();
    step(world, DT);
    expect(sensorEvents(world).end.count).toBe(1);
  });
});
