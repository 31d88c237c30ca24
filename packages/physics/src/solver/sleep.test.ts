// Bodies at rest sleep together and wake together.
import {
  applyImpulse,
  asleepCount,
  box,
  createJoint,
  despawn,
  distance,
  isAsleep,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  putToSleep,
  restore,
  snapshot,
  softStep,
  spawn,
  stateHash,
  step,
  uniformGravity,
  wake,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { rigidTable } from './rigid-table.ts';

const addGround = (world: PhysicsWorld) =>
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.6 } });

const addBox = (world: PhysicsWorld, x: number, y: number) =>
  spawn(world, { position: { x, y }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });

/** A stack of three and a box apart from it, all asleep. */
function sleepingWorld(options: PhysicsWorldOptions = {}) {
  const world = rigidWorld(options);
  const ground = addGround(world);
  const stack = [0, 1, 2].map((i) => addBox(world, 0, 0.5 + i));
  const apart = addBox(world, 10, 0.5);
  run(world, 3);
  expect(asleepCount(world)).toBe(4);
  return { world, ground, stack, apart };
}

test('bodies at rest sleep, and then nothing moves', () => {
  const { world } = sleepingWorld();
  const before = stateHash(world);
  const { time } = world;
  run(world, 1);
  world.time = time;
  expect(stateHash(world)).toBe(before);
});

test('contacts of what sleeps are passed over, also while others move', () => {
  const { world, stack } = sleepingWorld();
  const { words } = rigidTable(world);
  const looked = () => words[Word.currentCount];
  run(world, 2 * DT);
  expect([words[Word.contactCount], looked()]).toEqual([4, 0]);
  const ball = spawn(world, { position: { x: 20, y: 3 }, collider: { radius: 0.4, density: 2 } });
  run(world, 0.8);
  expect([words[Word.contactCount], looked()]).toEqual([5, 1]);
  expect(asleepCount(world)).toBe(4);
  despawn(world, ball);
  putToSleep(world, stack[0]);
  run(world, 3 * DT);
  expect([words[Word.contactCount], looked()]).toEqual([4, 0]);
});

test('a falling body wakes the stack that it hits, with its momentum, and nothing else', () => {
  const { world, stack, apart } = sleepingWorld();
  const ball = spawn(world, {
    position: { x: -3, y: 2.5 },
    velocity: { x: 8, y: 1 },
    collider: { radius: 0.4, density: 2 },
  });
  const { Velocity, Mass } = world.components;
  const mass = Mass.value[stack[2]];
  while (Velocity.x[stack[2]] === 0 && world.time < 5) step(world, DT);
  expect(isAsleep(world, stack[0])).toBe(false);
  expect(isAsleep(world, apart)).toBe(true);
  const momentum = Mass.value[ball] * Velocity.x[ball] + stack.reduce((sum, id) => sum + mass * Velocity.x[id], 0);
  // Friction with the ground takes some of it within the step.
  expect(momentum / (8 * Mass.value[ball])).toBeGreaterThan(0.85);
  run(world, 10);
  expect(asleepCount(world)).toBeGreaterThan(3);
});

test('what changes a sleeping body wakes it', () => {
  const { world, ground, stack, apart } = sleepingWorld();
  const awake = () => [isAsleep(world, stack[0]), isAsleep(world, apart)].map((asleep) => !asleep);
  const changes: [() => void, boolean[]][] = [
    [() => applyImpulse(world, apart, { x: 1 }), [false, true]],
    [() => (world.components.Position.y[apart] += 0.1), [false, true]],
    [() => wake(world, stack[2]), [true, false]],
    [() => despawn(world, stack[1]), [true, false]],
    [() => world.forces.push(uniformGravity({ x: 1 })), [true, true]],
    [() => (world.components.Position.y[ground] -= 0.2), [true, true]],
  ];
  for (const [change, expected] of changes) {
    change();
    run(world, 3 * DT);
    expect(awake()).toEqual(expected);
    if (world.forces.length > 1) world.forces.pop();
    run(world, 4);
    expect(awake()).toEqual([false, false]);
  }
  despawn(world, ground);
  run(world, 3 * DT);
  expect(awake()).toEqual([true, true]);
});

test('an island sleeps as a whole: a joint keeps a resting body awake while its other end swings', () => {
  const world = rigidWorld();
  addGround(world);
  const resting = addBox(world, 0, 0.5);
  const swinging = spawn(world, { position: { x: 2, y: 4 }, mass: 0.01 });
  createJoint(world, distance({ a: resting, b: swinging }));
  run(world, 2);
  expect(isAsleep(world, resting)).toBe(false);
  const other = addBox(world, 20, 0.5);
  run(world, 2);
  expect(isAsleep(world, other)).toBe(true);
});

test('a body that sleeps on its rope falls when that is gone', () => {
  const world = rigidWorld();
  const hook = spawn(world, { position: { y: 2 } });
  const load = spawn(world, { position: { y: 1 }, mass: 1 });
  const rope = createJoint(world, distance({ a: hook, b: load, collide: true }));
  run(world, 2);
  expect(isAsleep(world, load)).toBe(true);
  expect(world.components.Position.y[load]).toBeCloseTo(1, 2);
  world.components.Position.y[hook] = 3;
  run(world, 3);
  expect(world.components.Position.y[load]).toBeCloseTo(2, 2);
  despawn(world, rope);
  run(world, 1);
  expect(world.components.Position.y[load]).toBeLessThan(-2);
});

test('what moves without mass carries bodies, wakes them and keeps them awake', () => {
  const world = rigidWorld();
  const platform = spawn(world, {
    position: { y: -0.5 },
    velocity: {},
    collider: { shape: box(10, 1), friction: 1 },
  });
  const load = addBox(world, 0, 0.5);
  run(world, 2);
  expect(isAsleep(world, load)).toBe(true);
  world.components.Velocity.x[platform] = 0.5;
  run(world, 3);
  expect(isAsleep(world, load)).toBe(false);
  expect(world.components.Velocity.x[load]).toBeCloseTo(0.5, 3);
});

// A crate that sticks to the belt goes v t; what it takes to get up to v, v²/2μg, is below 0.1 mm, and contacts that settle move it
// by less than a millimetre.
test.each([
  ['f32', 0.002],
  ['f64', 0.002],
  ['f32', 0.03],
  ['f64', 0.03],
] as const)(
  'in %s a belt of %s m/s carries what lies on it, and lets what a stop holds sleep until it is gone',
  (precision, speed) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.6, tangentSpeed: speed } });
    const stop = spawn(world, { position: { x: 21, y: 0.5 }, collider: { shape: box(1, 1), friction: 0.6 } });
    const [free, held] = [addBox(world, 0, 0.5), addBox(world, 20, 0.5)];
    const { x } = world.components.Position;
    run(world, 10);
    expect(isAsleep(world, free)).toBe(false);
    expect(Math.abs(x[free] - 10 * speed)).toBeLessThan(0.001);
    expect(isAsleep(world, held)).toBe(true);
    despawn(world, stop);
    const from = x[held];
    run(world, 10);
    expect(Math.abs(x[held] - from - 10 * speed)).toBeLessThan(0.001);
  },
);

describe('putToSleep', () => {
  test('a new stack sleeps after one step, exactly where it is, until something hits it', () => {
    const world = rigidWorld();
    addGround(world);
    const stack = [0, 1, 2].map((i) => addBox(world, 0, 0.5 + i));
    const apart = addBox(world, 10, 0.5);
    putToSleep(world, stack[1]);
    step(world, DT);
    expect(stack.map((id) => isAsleep(world, id))).toEqual([true, true, true]);
    expect(isAsleep(world, apart)).toBe(false);
    const before = stack.map((id) => world.components.Position.y[id]);
    run(world, 1);
    expect(stack.map((id) => world.components.Position.y[id])).toEqual(before);
    applyImpulse(world, stack[2], { x: 1 });
    step(world, DT);
    expect(isAsleep(world, stack[0])).toBe(false);
  });

  test('what flies stops in the air, and wakes by `wake`', () => {
    const world = rigidWorld();
    const ball = spawn(world, { position: { y: 5 }, velocity: { x: 3 }, collider: { radius: 0.2, density: 1 } });
    run(world, 0.5);
    putToSleep(world, ball);
    run(world, 1);
    const { Position, Velocity } = world.components;
    expect([Velocity.x[ball], Velocity.y[ball]]).toEqual([0, 0]);
    expect(Position.x[ball]).toBeCloseTo(3 * (0.5 + DT), 12);
    wake(world, ball);
    run(world, 1);
    expect(Velocity.y[ball]).toBeCloseTo(-9.81, 1);
  });

  test('it counts once, and not for another body of the same id', () => {
    const world = rigidWorld();
    const gone = addBox(world, 0, 5);
    putToSleep(world, gone);
    despawn(world, gone);
    const next = addBox(world, 0, 5);
    expect(next).toBe(gone);
    run(world, 1);
    expect(isAsleep(world, next)).toBe(false);
    putToSleep(world, next);
    step(world, DT);
    wake(world, next);
    run(world, 1);
    expect(isAsleep(world, next)).toBe(false);
  });

  test('NeverSleep and a sleep time of 0 win', () => {
    const world = rigidWorld({ integrator: softStep({ sleepTime: 0 }) });
    const box = addBox(world, 0, 5);
    putToSleep(world, box);
    run(world, 3 * DT);
    expect(isAsleep(world, box)).toBe(false);
    const other = rigidWorld();
    const sleepless = spawn(other, { position: {}, neverSleep: {}, collider: { radius: 1, density: 1 } });
    putToSleep(other, sleepless);
    run(other, 1);
    expect(other.components.Velocity.y[sleepless]).toBeLessThan(-9);
  });

  test('asked between a snapshot and the next step it is forgotten by restore, asked before it is done', () => {
    const world = rigidWorld();
    const ball = addBox(world, 0, 5);
    step(world, DT);
    const before = snapshot(world);
    putToSleep(world, ball);
    const asked = snapshot(world);
    restore(world, before);
    step(world, DT);
    expect(isAsleep(world, ball)).toBe(false);
    restore(world, asked);
    step(world, DT);
    expect(isAsleep(world, ball)).toBe(true);
  });
});

test('with a sleep time of 0 nobody sleeps', () => {
  const world = rigidWorld({ integrator: softStep({ sleepTime: 0 }) });
  addGround(world);
  addBox(world, 0, 0.5);
  run(world, 2);
  expect(asleepCount(world)).toBe(0);
});

test.each(['f32', 'f64'] as const)(
  'a restored world goes on to the bit in %s, with sleepers, contacts and joints',
  (precision) => {
    const { world, stack } = sleepingWorld({ precision });
    const bob = spawn(world, { position: { x: 3, y: 3 }, mass: 1, collider: { radius: 0.2 } });
    createJoint(world, distance({ a: stack[2], b: bob }));
    run(world, 0.5);
    const before = snapshot(world);
    run(world, 2);
    const hash = stateHash(world);
    restore(world, before);
    run(world, 2);
    expect(stateHash(world)).toBe(hash);
  },
);

describe.each([0.2, 1.62, 9.81])('under %s m/s²', (g) => {
  const world = () => rigidWorld({ forces: [uniformGravity({ y: -g })] });

  test('a block that stands on a corner, 3 degrees off, falls on its side before it sleeps', () => {
    const weak = world();
    addGround(weak);
    const angle = Math.PI / 4 + 0.05;
    const position = { y: 0.5 * (Math.cos(angle) + Math.sin(angle)) };
    const block = spawn(weak, { position, rotation: angle, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
    for (let i = 0; i < 3000 && !isAsleep(weak, block); i++) step(weak, DT);
    expect(isAsleep(weak, block)).toBe(true);
    expect(weak.components.Rotation.angle[block]).toBeCloseTo(Math.PI / 2, 2);
  });

  test('a block that lies on the ground sleeps after half a second, and one in slow flight does not', () => {
    const weak = world();
    addGround(weak);
    const block = addBox(weak, 0, 0.5);
    // It is slower than 5 cm/s for half a second about its summit, where that is weakest.
    const flying = addBox(weak, 5, 2);
    weak.components.Velocity.y[flying] = 0.045;
    run(weak, 0.6);
    expect(isAsleep(weak, block)).toBe(true);
    expect(isAsleep(weak, flying)).toBe(false);
    run(weak, 30 / g);
    expect(weak.components.Position.y[flying]).toBeCloseTo(0.5, 2);
  });
});
