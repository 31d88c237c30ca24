// What sleeps on a joint is met by everything, whatever comes or goes elsewhere.
import {
  box,
  contactEvents,
  createEmitter,
  createJoint,
  createPhysicsWorld,
  decodeSnapshot,
  despawn,
  encodeSnapshot,
  filterJoint,
  isAsleep,
  type PhysicsWorld,
  restore,
  revolute,
  rigidBodies,
  sensorEvents,
  snapshot,
  spawn,
  spawnCompound,
  step,
  uniformGravity,
  weld,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

const SQUARE = { shape: box(1, 1), density: 10 };
const RADIUS = 0.3;

/** Makes something with its middle at (5, 1) that falls asleep on a joint and touches nothing. */
const HUNG: Readonly<Record<string, (world: PhysicsWorld) => number>> = {
  'a crate that hangs from a static beam': (world) => hang(world, {}),
  'a crate that hangs from a kinematic beam': (world) => hang(world, { kinematic: {}, velocity: {} }),
  'a crate welded to one that hangs': (world) => {
    const upper = hang(world, {}, 2);
    const crate = spawn(world, { position: { x: 5, y: 1 }, collider: SQUARE });
    createJoint(world, weld({ a: upper, b: crate, anchor: { x: 5, y: 1.5 } }));
    return crate;
  },
  'one of two welded crates that float': (world) => {
    const weightless = { gravityScale: 0, collider: SQUARE };
    const a = spawn(world, { position: { x: 5, y: 2 }, ...weightless });
    const b = spawn(world, { position: { x: 5, y: 1 }, ...weightless });
    createJoint(world, weld({ a, b, anchor: { x: 5, y: 1.5 } }));
    return b;
  },
  'a compound body that hangs': (world) => {
    const beam = addBeam(world, {});
    const { body } = spawnCompound(world, { position: { x: 5, y: 1 }, parts: [SQUARE, { ...SQUARE, y: -1 }] });
    createJoint(world, revolute({ a: beam, b: body, anchor: { x: 5, y: 2.5 } }));
    return body;
  },
};

/** What happens elsewhere. */
const CHANGES: Readonly<Record<string, (world: PhysicsWorld) => PhysicsWorld>> = {
  'a disc is spawned': (world) => spawnFar(world),
  'a disc is spawned and removed': (world) => {
    const disc = spawn(world, { position: { x: 500 }, collider: { radius: 1 } });
    step(world, DT);
    despawn(world, disc);
    return world;
  },
  'an emitter is made': (world) => {
    createEmitter(world, { capacity: 4, lifetime: 1, rate: 1, position: { x: 500 }, collider: { radius: 0.1 } });
    return world;
  },
  'other bodies are joined': (world) => {
    const a = spawn(world, { position: { x: 500 }, collider: SQUARE });
    const b = spawn(world, { position: { x: 503 }, collider: SQUARE });
    createJoint(world, weld({ a, b, anchor: { x: 501 } }));
    return world;
  },
  'a wall is spawned, and moved': (world) => {
    const wall = spawn(world, { planeWall: { offset: -500 } });
    step(world, DT);
    world.components.PlaneWall.offset[wall] = -400;
    return world;
  },
  'the world is restored after a spawn': (world) => {
    const before = snapshot(world);
    spawnFar(world);
    run(world, 0.1);
    restore(world, before);
    return spawnFar(world);
  },
  'another world takes its state': (world) => {
    const other = makeWorld();
    restore(other, decodeSnapshot(other, encodeSnapshot(snapshot(world))));
    return spawnFar(other);
  },
};

function makeWorld(): PhysicsWorld {
  return createPhysicsWorld({ preset: rigidBodies, capacity: 60, forces: [uniformGravity({ y: -10 })] });
}

function addBeam(world: PhysicsWorld, kind: object): number {
  return spawn(world, { position: { x: 5, y: 2.5 }, collider: { shape: box(0.2, 0.2) }, ...kind });
}

function hang(world: PhysicsWorld, kind: object, y = 1): number {
  const beam = addBeam(world, kind);
  const crate = spawn(world, { position: { x: 5, y }, collider: SQUARE });
  createJoint(world, revolute({ a: beam, b: crate, anchor: { x: 5, y: 2.5 } }));
  return crate;
}

function spawnFar(world: PhysicsWorld): PhysicsWorld {
  spawn(world, { position: { x: 500 }, collider: { radius: 1 } });
  return world;
}

describe.each(Object.entries(HUNG))('%s', (_name, make) => {
  test.each(Object.entries(CHANGES))('is met after %s', (_change, change) => {
    const world = makeWorld();
    const crate = make(world);
    run(world, 3);
    expect(isAsleep(world, crate)).toBe(true);
    const later = change(world);
    step(later, DT);
    // Nothing came near.
    expect(isAsleep(later, crate)).toBe(true);
    const { Position, Velocity } = later.components;
    const sensor = spawn(later, { position: { x: 5, y: 1 }, collider: { radius: 0.2, sensor: true }, velocity: {} });
    later.components.Velocity.x[sensor] = 1e-3;
    step(later, DT);
    expect(sensorEvents(later).begin.count).toBeGreaterThan(0);
    despawn(later, sensor);
    const ball = spawn(later, {
      position: { x: 2, y: 1 },
      velocity: { x: 10 },
      gravityScale: 0,
      collider: { radius: RADIUS, density: 30 },
    });
    let begins = 0;
    for (let i = 0; i < 30; i++) {
      step(later, DT);
      begins += contactEvents(later).begin.count;
      const apart = Math.hypot(Position.x[ball] - Position.x[crate], Position.y[ball] - Position.y[crate]);
      expect(apart).toBeGreaterThan(0.5 + RADIUS - SLOP);
    }
    expect(begins).toBeGreaterThan(0);
    expect(Velocity.x[ball]).toBeLessThan(10);
  });
});

test('two bodies that sleep in one place part when no filter joint keeps them from colliding any more', () => {
  const world = rigidWorld({ forces: [] });
  const a = spawn(world, { position: {}, collider: SQUARE });
  const b = spawn(world, { position: { x: 0.3 }, collider: SQUARE });
  const joint = createJoint(world, filterJoint({ a, b }));
  run(world, 2);
  expect([isAsleep(world, a), isAsleep(world, b)]).toEqual([true, true]);
  despawn(world, joint);
  run(world, 1);
  const { Position } = world.components;
  expect(Math.abs(Position.x[b] - Position.x[a])).toBeGreaterThan(1 - 2 * SLOP);
});
