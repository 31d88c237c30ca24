// Sensors: what overlaps them begins and ends once, moves as if they were not there, and fast bodies are not missed.
import {
  box,
  createJoint,
  despawn,
  distance,
  isAsleep,
  type PhysicsWorld,
  restore,
  segment,
  sensorEvents,
  snapshot,
  spawn,
  spawnCompound,
  step,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** The events of some steps, as `[step, begins, sensor, visitor]`. */
function record(world: PhysicsWorld, steps: number): [number, boolean, number, number][] {
  const events: [number, boolean, number, number][] = [];
  const { begin, end } = sensorEvents(world);
  for (let i = 0; i < steps; i++) {
    step(world, DT);
    for (let k = 0; k < begin.count; k++) events.push([i, true, begin.sensor[k], begin.visitor[k]]);
    for (let k = 0; k < end.count; k++) events.push([i, false, end.sensor[k], end.visitor[k]]);
  }
  return events;
}

describe.each(['f32', 'f64'] as const)('a sensor in %s', (precision) => {
  it('begins and ends when a ball falls through it, at the times of free fall', () => {
    const world = rigidWorld({ precision });
    const zone = spawn(world, { position: { y: -2 }, collider: { shape: box(4, 1), sensor: true } });
    const ball = spawn(world, { position: {}, collider: { radius: 0.25, density: 1 } });
    const events = record(world, 60);
    // The ball has fallen by 1.25 m when it meets the upper side, and by 2.75 m when it leaves the lower one.
    const times = [1.25, 2.75].map((h) => Math.sqrt((2 * h) / 9.80665) / DT);
    expect(events.map(([, begins, sensor, visitor]) => [begins, sensor, visitor])).toEqual([
      [true, zone, ball],
      [false, zone, ball],
    ]);
    for (const [i, [at]] of events.entries()) expect(Math.abs(at - times[i])).toBeLessThan(2);
    // Nothing slowed it.
    expect(world.components.Velocity.y[ball]).toBeCloseTo(-9.80665, 3);
  });

  it('does not miss a fast ball, thin as it is', () => {
    const world = rigidWorld({ precision, forces: [] });
    const gate = spawn(world, { position: {}, collider: { shape: segment({ y: -5 }, { y: 5 }), sensor: true } });
    spawn(world, { position: { x: 30 }, collider: { shape: box(1, 10) } });
    const ball = spawn(world, { position: { x: -10.2 }, velocity: { x: 600 }, collider: { radius: 0.1, density: 1 } });
    const events = record(world, 10);
    expect(events).toEqual([
      [1, true, gate, ball],
      [1, false, gate, ball],
    ]);
  });

  it.each([
    ['kinematic', { velocity: {}, kinematic: {} }, 0],
    ['asleep', { velocity: {}, mass: 1 }, 100],
    ['awake', { velocity: {}, mass: 1, neverSleep: {} }, 0],
  ] as const)('does not miss a fast ball where it may move, but rests: %s', (how, body, steps) => {
    const world = rigidWorld({ precision, forces: [] });
    const gate = spawn(world, { ...body, position: {}, collider: { shape: box(0.1, 2), sensor: true } });
    record(world, steps);
    expect(isAsleep(world, gate)).toBe(how === 'asleep');
    const ball = spawn(world, { position: { x: -4.2 }, velocity: { x: 100 }, collider: { radius: 0.1, density: 1 } });
    expect(record(world, 6)).toEqual([
      [2, true, gate, ball],
      [2, false, gate, ball],
    ]);
    expect(isAsleep(world, gate)).toBe(how === 'asleep');
  });

  it('senses ground and platforms as a part of a body, and not its own body', () => {
    const world = rigidWorld({ precision });
    const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
    const { body, parts } = spawnCompound(world, {
      position: { y: 1 },
      parts: [
        { shape: box(0.5, 1), density: 1, friction: 0.6 },
        { shape: box(0.4, 0.1), y: -0.52, sensor: true },
      ],
    });
    const events = record(world, 60);
    expect(events.map(([, ...rest]) => rest)).toEqual([[true, parts[1], ground]]);
    world.components.Velocity.y[body] = 5;
    expect(record(world, 10).map(([, ...rest]) => rest)).toEqual([[false, parts[1], ground]]);
  });

  it('neither wakes nor keeps awake, and keeps what sleeps in it', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
    const zone = spawn(world, { position: { y: 0.5 }, collider: { shape: box(3, 1), sensor: true } });
    const crate = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
    expect(record(world, 120).map(([, ...rest]) => rest)).toEqual([[true, zone, crate]]);
    expect(isAsleep(world, crate)).toBe(true);
    const probe = spawn(world, {
      position: { x: -3, y: 0.5 },
      velocity: { x: 3 },
      collider: { shape: box(1, 0.2), sensor: true },
    });
    expect(record(world, 120).map(([, ...rest]) => rest)).toEqual([
      [true, probe, crate],
      [false, probe, crate],
    ]);
    expect(isAsleep(world, crate)).toBe(true);
    despawn(world, crate);
    expect(record(world, 1).map(([, ...rest]) => rest)).toEqual([[false, zone, crate]]);
  });
});

test('sensors do not sense each other, layers and groups filter what they sense, and moving ones sense what is static', () => {
  const world = rigidWorld({ forces: [] });
  spawn(world, { position: {}, collider: { radius: 1, sensor: true } });
  spawn(world, { position: {}, velocity: { x: 0.1 }, collider: { radius: 1, sensor: true } });
  const walker = spawn(world, {
    position: { x: 10 },
    velocity: { x: 1 },
    collider: { radius: 1, sensor: true, mask: 2, group: -3 },
  });
  spawn(world, { position: { x: 12 }, collider: { radius: 0.5 } });
  const wall = spawn(world, { position: { x: 12 }, collider: { radius: 0.5, layers: 2 } });
  spawn(world, { position: { x: 12 }, collider: { radius: 0.5, layers: 2, group: -3 } });
  expect(record(world, 60).map(([, ...rest]) => rest)).toEqual([[true, walker, wall]]);
});

test.each(['f32', 'f64'] as const)(
  'in %s what has a velocity is sensed by sensors at rest, also while it stands',
  (precision) => {
    const world = rigidWorld({ precision, forces: [] });
    const zone = spawn(world, { position: {}, collider: { shape: box(2, 2), sensor: true } });
    const block = spawn(world, { position: {}, collider: { shape: box(0.5, 0.5) } });
    const lift = spawn(world, { position: {}, velocity: {}, collider: { shape: box(0.5, 0.5) } });
    const probe = spawn(world, { position: {}, angularVelocity: 1, collider: { shape: box(0.1, 0.1), sensor: true } });
    const { Position, Velocity, AngularVelocity } = world.components;
    expect(record(world, 2)).toEqual([
      [0, true, zone, lift],
      [0, true, probe, block],
      [0, true, probe, lift],
    ]);
    Velocity.y[lift] = 0.1;
    record(world, 2);
    Velocity.y[lift] = 0;
    AngularVelocity.z[probe] = 0;
    expect(record(world, 5)).toEqual([]);
    Position.x[lift] = 5;
    expect(record(world, 2).map(([, ...rest]) => rest)).toEqual([
      [false, zone, lift],
      [false, probe, lift],
    ]);
    Position.x[lift] = 1;
    expect(record(world, 2).map(([, ...rest]) => rest)).toEqual([[true, zone, lift]]);
  },
);

test('a body that becomes a sensor is left by what lies on it, and the other way round', () => {
  const world = rigidWorld();
  const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1) } });
  const crate = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });
  record(world, 90);
  world.components.Collider.sensor[floor] = 1;
  const events = record(world, 60);
  expect(events[0]).toEqual([0, true, floor, crate]);
  expect(world.components.Position.y[crate]).toBeLessThan(-1);
  world.components.Position.y[crate] = 1;
  world.components.Velocity.y[crate] = 0;
  world.components.Collider.sensor[floor] = 0;
  record(world, 60);
  expect(world.components.Position.y[crate]).toBeCloseTo(0.5, 2);
});

test.each([{}, { velocity: {}, kinematic: {} }])(
  'joined bodies do not sense each other, also where one passes: %j',
  (kind) => {
    const world = rigidWorld({ forces: [] });
    const hub = spawn(world, { ...kind, position: {}, collider: { shape: box(0.1, 2), sensor: true } });
    const ball = spawn(world, { position: { x: -1 }, velocity: { x: 100 }, collider: { radius: 0.1, density: 1 } });
    createJoint(world, distance({ a: hub, b: ball, limits: { upper: 50 } }));
    expect(record(world, 3)).toEqual([]);
    expect(world.components.Position.x[ball]).toBeGreaterThan(1);
  },
);

test('where two that overlap exchange which of them is the sensor, one pair ends and the other begins', () => {
  const world = rigidWorld({ forces: [] });
  const [a, b] = [true, false].map((sensor, i) =>
    spawn(world, { position: { x: i / 2 }, velocity: {}, mass: 1, collider: { radius: 1, sensor } }),
  );
  const { Collider, Position } = world.components;
  expect(record(world, 2)).toEqual([[0, true, a, b]]);
  [Collider.sensor[a], Collider.sensor[b]] = [0, 1];
  expect(record(world, 2)).toEqual([
    [0, true, b, a],
    [0, false, a, b],
  ]);
  Position.x[b] = 5;
  expect(record(world, 2)).toEqual([[0, false, b, a]]);
});

test('events repeat after a restore', () => {
  const world = rigidWorld();
  spawn(world, { position: { y: -2 }, collider: { shape: box(4, 1), sensor: true } });
  for (let i = 0; i < 5; i++) spawn(world, { position: { x: i - 2, y: i }, collider: { radius: 0.25, density: 1 } });
  record(world, 30);
  const kept = snapshot(world);
  const events = record(world, 60);
  restore(world, kept);
  expect(record(world, 60)).toEqual(events);
  expect(events.length).toBeGreaterThan(4);
});
