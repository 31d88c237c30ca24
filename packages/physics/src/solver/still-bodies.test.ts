// What may fall asleep: what rests, but not what drifts, swings or is about to turn back; and by which forces it wakes.
import {
  attractors,
  box,
  buoyancy,
  createJoint,
  createPhysicsWorld,
  distance,
  immersedDrag,
  isAsleep,
  linearDrag,
  momentum,
  type PhysicsWorld,
  putToSleep,
  revolute,
  rigidBodies,
  softStep,
  spawn,
  springs,
  step,
  uniformGravity,
  weld,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** The defaults of softStep: the speed that counts as still, m/s, and the time until sleep, s. */
const [SPEED, TIME] = [0.05, 0.5];
/** What wakes a body that is held, and one that nothing holds, m/s²: see docs/rigid-bodies.md, Sleep. */
const [HELD, FREE] = [(0.1 * SPEED) / TIME, (0.001 * SPEED) / TIME];

const space = (forces: PhysicsWorld['forces'] = []) => createPhysicsWorld({ preset: rigidBodies, forces });

const puck = (world: PhysicsWorld, more: object = {}) =>
  spawn(world, { position: {}, velocity: {}, mass: 1, collider: 0.1, ...more });

describe('what nothing holds', () => {
  test.each([0.04, 0.004, 0.0004])('goes on at %s m/s', (speed) => {
    const world = space();
    const body = puck(world, { velocity: { x: speed } });
    run(world, 10);
    expect(world.components.Position.x[body]).toBeCloseTo(10 * speed, 10);
    expect(momentum(world).x).toBe(speed);
  });

  test('goes on if two are joined, and if they touch', () => {
    const world = space();
    const at = (x: number, y: number) => puck(world, { position: { x, y }, velocity: { x: 0.03 } });
    createJoint(world, distance({ a: at(0, 0), b: at(1, 0) }));
    at(0, 5);
    at(0.2, 5);
    run(world, 10);
    // Four bodies of 1 kg, to the rounding of a few thousand sums.
    expect(momentum(world).x).toBeCloseTo(0.12, 10);
  });

  test('goes on along a circle, slower than 5 cm/s', () => {
    const world = space([attractors()]);
    const [r, v] = [500, Math.sqrt(1 / 500)];
    spawn(world, { position: {}, attractor: 1 });
    const moon = puck(world, { position: { x: r }, velocity: { y: v } });
    run(world, 100);
    // Semi-implicit Euler with a sub-step h: the angle is right to ω h / 2, here 2e-7.
    expect(world.components.Position.y[moon]).toBeCloseTo(r * Math.sin((100 * v) / r), 4);
  });

  test('sleeps where it is at rest and no force acts, and where drag has stopped it', () => {
    const world = space([linearDrag()]);
    const resting = puck(world);
    const sliding = puck(world, { position: { y: 5 }, velocity: { x: 0.1 }, linearDrag: 2 });
    run(world, 0.6);
    expect([resting, sliding].map((id) => isAsleep(world, id))).toEqual([true, false]);
    run(world, 4);
    expect(isAsleep(world, sliding)).toBe(true);
    // It comes to v/k; drag takes the velocity at the start of a sub-step, an error of k h/2, and sleep a thousandth of 5 cm/s.
    expect(world.components.Position.x[sliding]).toBeCloseTo(0.05, 3);
  });

  test.each([0.5 * FREE, 2 * FREE])('that sleeps feels a force of %s m/s², or not', (acceleration) => {
    const world = space();
    const body = puck(world);
    run(world, 1);
    world.forces.push(uniformGravity({ x: acceleration }));
    run(world, 3 * DT);
    expect(isAsleep(world, body)).toBe(acceleration < FREE);
  });

  test.each(['rests on it', 'is welded to it', 'hangs below it'])('sleeps afloat with cargo that %s', (cargo) => {
    const water = { density: 1000, level: 0, gravity: { y: -G } };
    const world = rigidWorld({ forces: [uniformGravity(), buoyancy(water), immersedDrag(water)] });
    const shape = box(2, 0.5);
    const hull = { shape: 1 };
    const raft = spawn(world, {
      position: {},
      collider: { shape, density: 500 },
      hull,
      linearDrag: 3000,
      motionLocks: { angle: true },
    });
    const y = cargo === 'hangs below it' ? -1 : 0.35;
    const crate = spawn(world, { position: { y }, velocity: {}, mass: 60, collider: { shape: box(0.2, 0.2) } });
    if (cargo === 'is welded to it') createJoint(world, weld({ a: raft, b: crate, anchor: { y: 0.25 } }));
    if (cargo === 'hangs below it') createJoint(world, distance({ a: raft, b: crate }));
    run(world, 10);
    expect([raft, crate].map((id) => isAsleep(world, id))).toEqual([true, true]);
    // Archimedes: 560 kg displace 0.56 m² of 1 m depth, of a raft of 2 m by 0.5 m.
    expect(world.components.Position.y[raft]).toBeCloseTo(-0.03, 3);
  });

  test('swings on where two turn back in nothing more than the forces that would wake them', () => {
    const world = space([springs()]);
    // An amplitude A of each with the frequency ω, and ω² A = 1.5 FREE where they turn back.
    const [amplitude, omega] = [0.04, Math.sqrt((1.5 * FREE) / 0.04)];
    const [a, b] = [-1, 1].map((side) => puck(world, { position: { x: side * (1 + amplitude) } }));
    spawn(world, { spring: { a, b, stiffness: omega ** 2 / 2, length: 2 } });
    run(world, Math.PI / omega);
    // Half a period later each is on the other side, to the order ω h of semi-implicit Euler.
    expect(world.components.Position.x[b]).toBeCloseTo(1 - amplitude, 3);
  });
});

describe('what is held', () => {
  test('a rod that is let go at 0.01 rad swings on', () => {
    const world = rigidWorld();
    const angle = 0.01;
    const position = { x: 0.5 * Math.sin(angle), y: -0.5 * Math.cos(angle) };
    const rod = spawn(world, { position, rotation: angle, collider: { shape: box(0.02, 1), density: 50 } });
    createJoint(world, revolute({ b: rod, anchor: {} }));
    let [least, most] = [0, 0];
    for (let i = 0; i < 3600; i++) {
      step(world, DT);
      const now = world.components.Rotation.angle[rod];
      if (i > 3400) [least, most] = [Math.min(least, now), Math.max(most, now)];
    }
    // A period is 1.6 s, 98 steps, and a pendulum keeps 99 % of its energy in a minute (docs/rigid-bodies.md).
    expect(most).toBeGreaterThan(0.0098);
    expect(least).toBeLessThan(-0.0098);
  });

  test('a pendulum hands its swing to another by a weak spring', () => {
    const world = rigidWorld({ forces: [uniformGravity(), springs()] });
    const [amplitude, k] = [0.02, 0.3];
    const bob = (x: number, angle: number) => {
      const position = { x: x + Math.sin(angle), y: -Math.cos(angle) };
      const body = spawn(world, { position, velocity: {}, mass: 1, collider: 0.05 });
      createJoint(world, distance({ b: body, anchorA: { x, y: 0 } }));
      return body;
    };
    const [a, b] = [bob(0, amplitude), bob(1, 0)];
    spawn(world, { spring: { a, b, stiffness: k, length: 1 } });
    let largest = 0;
    // Its two modes have ω² = g/L and g/L + 2k/m: after π/Δω all of it is in the other.
    const beat = Math.PI / (Math.sqrt(G + 2 * k) - Math.sqrt(G));
    for (let i = 0; i * DT < 1.05 * beat; i++) {
      step(world, DT);
      largest = Math.max(largest, Math.abs(world.components.Position.x[b] - 1));
    }
    expect(largest).toBeGreaterThan(0.98 * amplitude);
  });

  test('what sleeps at one end of a spring wakes when the other end moves', () => {
    const world = rigidWorld({ forces: [uniformGravity(), springs()] });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1), friction: 1 } });
    const block = (x: number) =>
      spawn(world, { position: { x, y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 1 } });
    const [a, b] = [block(0), block(2)];
    spawn(world, { spring: { a, b, stiffness: 1e-3, length: 2 } });
    run(world, 2);
    expect([a, b].map((id) => isAsleep(world, id))).toEqual([true, true]);
    world.components.Velocity.y[a] = 1;
    run(world, 3 * DT);
    expect([a, b].map((id) => isAsleep(world, id))).toEqual([false, false]);
  });

  test.each([0.8 * HELD, 1.2 * HELD])('what sleeps on a rope feels a force of %s m/s², or not', (acceleration) => {
    const world = rigidWorld();
    const load = puck(world, { position: { y: -1 } });
    createJoint(world, distance({ b: load, anchorA: { x: 0, y: 0 } }));
    run(world, 2);
    expect(isAsleep(world, load)).toBe(true);
    world.forces.push(uniformGravity({ x: acceleration }));
    run(world, 3 * DT);
    expect(isAsleep(world, load)).toBe(acceleration < HELD);
  });

  test('the threshold scales with the settings of sleep', () => {
    const integrator = softStep({ sleepSpeed: 0.5, sleepTime: 0.25 });
    const world = rigidWorld({ integrator });
    const load = puck(world, { position: { y: -1 } });
    createJoint(world, distance({ b: load, anchorA: { x: 0, y: 0 } }));
    run(world, 2);
    for (const [x, asleep] of [
      [0.19, true],
      [0.21, false],
    ] as const) {
      world.forces.push(uniformGravity({ x }));
      run(world, 3 * DT);
      expect(isAsleep(world, load)).toBe(asleep);
      world.forces.pop();
      run(world, 3 * DT);
    }
  });

  test('a ball that rolls at 2 cm/s rolls on', () => {
    const world = rigidWorld();
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1), friction: 1 } });
    const collider = { radius: 0.5, density: 1, friction: 1 };
    const ball = spawn(world, { position: { y: 0.5 }, velocity: { x: 0.02 }, angularVelocity: -0.04, collider });
    run(world, 10);
    expect(world.components.Position.x[ball]).toBeCloseTo(0.2, 3);
  });
});

test('what is put to sleep in full flight against drag sleeps on', () => {
  const world = space([linearDrag()]);
  const body = puck(world, { velocity: { x: 3 }, linearDrag: 1 });
  putToSleep(world, body);
  for (let i = 0; i < 30; i++) {
    step(world, DT);
    expect(isAsleep(world, body)).toBe(true);
  }
  world.forces.push(uniformGravity({ x: 1 }));
  run(world, 3 * DT);
  expect(isAsleep(world, body)).toBe(false);
});
