// A rope over pulleys that is wound too far against something that is held: both give way a little, and nothing is thrown.
import {
  box,
  createJoint,
  jointForce,
  type PhysicsWorld,
  prismatic,
  pulley,
  revolute,
  spawn,
  step,
  weld,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const CRATE = { shape: box(1, 1), density: 50, mask: 0 };
const WHEELS = { pulleyA: { x: 3, y: 5 }, pulleyB: { x: 0, y: 5 } };
const SPEED = 0.5;

const crate = (world: PhysicsWorld) => spawn(world, { position: {}, collider: CRATE });
const post = (world: PhysicsWorld) => spawn(world, { position: { x: 3, y: 3 }, collider: { shape: box(0.2, 0.2) } });

/** What holds a crate at the origin. */
const HELD: Readonly<Record<string, (world: PhysicsWorld, b: number) => void>> = {
  'a lift at its limit': (world, b) =>
    createJoint(world, prismatic({ b, anchor: {}, axis: { y: 1 }, limits: { lower: -1, upper: 0.5 } })),
  'a crate welded to the world': (world, b) => createJoint(world, weld({ b, anchor: { y: -0.5 } })),
  'a crate on a hinge below it': (world, b) => createJoint(world, revolute({ b, anchor: { y: -0.5 } })),
  'a crate on a hinge at its centre': (world, b) => createJoint(world, revolute({ b, anchor: {} })),
};

describe.each(Object.entries(HELD))('%s', (_name, hold) => {
  test.each(['f32', 'f64'] as const)('stays where it is held as the rope is wound on for a metre, %s', (precision) => {
    const world = rigidWorld({ precision });
    const b = crate(world);
    hold(world, b);
    const rope = createJoint(world, pulley({ a: post(world), b, ...WHEELS }));
    const { Joint, Position, Velocity } = world.components;
    let [fastest, highest] = [0, 0];
    for (let i = 0; i < 5 / DT; i++) {
      if (i < 3 / DT) Joint.length[rope] -= SPEED * DT;
      step(world, DT);
      fastest = Math.max(fastest, Math.hypot(Velocity.x[b], Velocity.y[b]));
      highest = Math.max(highest, Position.y[b]);
    }
    // A rope that is shortened by its length moves bodies without giving them a speed.
    expect(fastest).toBeLessThan(1e-2);
    expect(highest).toBeLessThan(0.5 + 1e-2);
  });
});

test('a kinematic winch draws a lift to its limit and on', () => {
  const world = rigidWorld();
  const b = crate(world);
  createJoint(world, prismatic({ b, anchor: {}, axis: { y: 1 }, limits: { lower: -1, upper: 0.5 } }));
  const a = spawn(world, {
    position: { x: 3, y: 3 },
    kinematic: {},
    velocity: { y: -SPEED },
    collider: { shape: box(0.2, 0.2), mask: 0 },
  });
  const rope = createJoint(world, pulley({ a, b, ...WHEELS }));
  const { Position, Velocity } = world.components;
  for (let i = 0; i < 4 / DT; i++) {
    step(world, DT);
    expect(Math.abs(Velocity.y[b])).toBeLessThan(SPEED * 1.01);
    // Before the limit the rope bears the weight and nothing else.
    if (i === 30) expect(jointForce(world, rope)).toBeCloseTo(50 * G, 2);
  }
  expect(Position.y[b]).toBeLessThan(0.5 + 1e-2);
});

test('a drawbridge is drawn against its limit no faster than it was drawn up to it', () => {
  const world = rigidWorld();
  const b = spawn(world, { position: { x: 1.5 }, collider: { ...CRATE, shape: box(3, 0.2) } });
  createJoint(world, revolute({ b, anchor: {}, limits: { lower: -0.1, upper: 1.4 } }));
  const rope = createJoint(
    world,
    pulley({ a: post(world), b, pulleyA: { x: 3, y: 4 }, pulleyB: { y: 4 }, anchorB: { x: 3 } }),
  );
  const { Joint, Rotation, Velocity } = world.components;
  for (let i = 0; i < 15 / DT; i++) {
    Joint.length[rope] = Math.max(0.3, Joint.length[rope] - SPEED * DT);
    step(world, DT);
    expect(Math.hypot(Velocity.x[b], Velocity.y[b])).toBeLessThan(1e-2);
  }
  expect(Math.abs(Rotation.angle[b] - 1.4)).toBeLessThan(2e-2);
});

test('a hinge whose anchor goes away from a taut rope throws nothing', () => {
  const world = rigidWorld();
  const b = spawn(world, { position: {}, collider: { shape: box(0.5, 0.3), density: 10, mask: 0 } });
  const hinge = createJoint(world, revolute({ b, anchor: { x: 0.07 } }));
  createJoint(world, pulley({ a: post(world), b, pulleyA: { x: 3, y: 4 }, pulleyB: { y: 2 } }));
  const { Joint, Velocity } = world.components;
  for (let i = 0; i < 4 / DT; i++) {
    const way = Math.min(2, 0.02 * i);
    Joint.ax[hinge] = 0.07 + 0.6 * way;
    Joint.ay[hinge] = -0.8 * way;
    step(world, DT);
    // As fast as what hangs on a rod is thrown by such a hinge.
    expect(Math.hypot(Velocity.x[b], Velocity.y[b])).toBeLessThan(20);
  }
});

test('a load of a thousand times the mass of its hook hangs from the rope', () => {
  const world = rigidWorld();
  const hook = spawn(world, { position: {}, mass: 1, collider: { shape: box(0.2, 0.2), mask: 0 } });
  const load = spawn(world, { position: { y: -1 }, mass: 1000, collider: { shape: box(1, 1), mask: 0 } });
  createJoint(world, revolute({ a: hook, b: load, anchor: {} }));
  const rope = createJoint(world, pulley({ a: post(world), b: hook, ...WHEELS }));
  for (let i = 0; i < 10 / DT; i++) step(world, DT);
  expect(Math.abs(jointForce(world, rope) / (1001 * G) - 1)).toBeLessThan(1e-3);
  // The rope gives way by 1 mm, and the hinge by hardly anything.
  expect(Math.abs(world.components.Position.y[hook])).toBeLessThan(2e-3);
});
