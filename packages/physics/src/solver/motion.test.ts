// Bodies that do not move as forces and contacts alone would have it: kinematic ones, locked axes, scaled gravity, no sleep.
import {
  box,
  createPhysicsWorld,
  energy,
  isAsleep,
  momentum,
  softStep,
  spawn,
  spawnCompound,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, removeComponent } from 'bitecs';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('a kinematic body with mass keeps its velocity against a weight, and falls once it is released', () => {
    const world = rigidWorld({ precision });
    const plate = { shape: box(4, 0.2), density: 100, friction: 0.8 };
    const lift = spawn(world, { position: {}, velocity: { y: 0.5 }, kinematic: {}, collider: plate });
    const load = spawn(world, { position: { y: 0.6 }, collider: { shape: box(1, 1), density: 1e5, friction: 0.8 } });
    run(world, 2);
    const { Position, Velocity } = world.components;
    expect(Position.y[lift]).toBeCloseTo(1, 4);
    expect(Position.y[load] - Position.y[lift]).toBeCloseTo(0.6, 2);
    removeComponent(world, lift, world.components.Kinematic);
    run(world, 0.5);
    // From its 0.5 m/s it falls freely, as its load does.
    expect(Velocity.y[lift]).toBeCloseTo(0.5 - 0.5 * G, 1);
    addComponent(world, lift, world.components.Kinematic);
    const speed = Velocity.y[lift];
    run(world, 0.5);
    expect(Velocity.y[lift]).toBe(speed);
  });

  it('a body at rest with the mark is immovable, and carries others when its velocity is set', () => {
    const world = rigidWorld({ precision, forces: [] });
    const wall = spawn(world, { position: {}, kinematic: {}, collider: { shape: box(1, 1), density: 1 } });
    const ball = spawn(world, {
      position: { x: -2 },
      velocity: { x: 3 },
      collider: { radius: 0.5, density: 1e4, restitution: 1 },
    });
    run(world, 1);
    const { Position, Velocity } = world.components;
    expect(Position.x[wall]).toBe(0);
    expect(Velocity.x[ball]).toBeCloseTo(-3, 4);
  });

  it('a locked axis keeps its coordinate to the bit, and gives its impulse back as a wall does', () => {
    const world = rigidWorld({ precision, forces: [] });
    const locked = spawn(world, {
      position: {},
      velocity: { y: 1 },
      motionLocks: { x: true, angle: true },
      collider: { shape: box(1, 1), density: 1 },
    });
    const ball = spawn(world, {
      position: { x: -1.5, y: 0.3 },
      velocity: { x: 3 },
      collider: { radius: 0.5, density: 1, restitution: 1 },
    });
    run(world, 1);
    const { Position, Rotation, Velocity } = world.components;
    expect([Position.x[locked], Rotation.angle[locked]]).toEqual([0, 0]);
    expect(Velocity.x[ball]).toBeCloseTo(-3, 3);
    expect(Velocity.y[locked]).toBeCloseTo(1, 5);
  });

  it('a kinematic body does not move along a locked axis either, nor turn', () => {
    const world = rigidWorld({ precision });
    const lift = spawn(world, {
      position: {},
      rotation: 0,
      velocity: { x: 1, y: 1 },
      angularVelocity: 1,
      kinematic: {},
      motionLocks: { x: true, angle: true },
      collider: { shape: box(4, 0.2), friction: 0.8 },
    });
    const crate = { shape: box(1, 1), density: 1, friction: 0.8 };
    const load = spawn(world, { position: { y: 0.6 }, velocity: { y: 1 }, collider: crate });
    run(world, 1);
    const { Position, Rotation, Velocity } = world.components;
    expect([Position.x[lift], Rotation.angle[lift], Velocity.x[lift]]).toEqual([0, 0, 0]);
    expect(Position.y[lift]).toBeCloseTo(1, 4);
    expect(Math.abs(Position.x[load])).toBeLessThan(1e-3);
    expect(Position.y[load]).toBeCloseTo(1.6, 2);
  });

  it('a body on a rail hands momentum along it to another', () => {
    const world = rigidWorld({ precision, forces: [uniformGravity()] });
    const rail = { motionLocks: { y: 1, angle: 1 }, collider: { shape: box(1, 1), density: 1, restitution: 1 } };
    const [a, b] = [0, 2].map((x) =>
      spawn(world, { position: { x, y: 5 }, velocity: { x: x === 0 ? 2 : 0 }, ...rail }),
    );
    run(world, 2);
    const { Position, Velocity } = world.components;
    // Equal masses exchange their velocities in an elastic impact, and gravity pulls neither off the rail.
    expect(Velocity.x[a]).toBeCloseTo(0, 3);
    expect(Velocity.x[b]).toBeCloseTo(2, 3);
    expect([Position.y[a], Position.y[b]]).toEqual([5, 5]);
  });

  it('a locked angle keeps a box upright on a slope, and a stack leans on locked boxes', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, rotation: 0.3, collider: { shape: box(40, 1), friction: 1 } });
    const upright = spawn(world, {
      position: { y: 2 },
      motionLocks: { angle: 1 },
      collider: { shape: box(0.5, 1), density: 1, friction: 1 },
    });
    run(world, 2);
    expect(world.components.Rotation.angle[upright]).toBe(0);
    expect(Math.abs(world.components.Velocity.x[upright])).toBeLessThan(1e-2);
  });

  it('falls by its scale of gravity', () => {
    const world = rigidWorld({ precision });
    const fall = (scale?: number) =>
      spawn(world, { position: { x: 3 * (scale ?? 5) }, mass: 2, gravityScale: scale, collider: 0.1 });
    const [plain, none, half, up] = [fall(), fall(0), fall(0.5), fall(-1)];
    run(world, 1);
    const { y } = world.components.Velocity;
    expect([y[plain], y[none], y[half], y[up]].map((v) => v / G)).toEqual(
      [-1, 0, -0.5, 1].map((v) => expect.closeTo(v, 5)),
    );
    // Fallen from rest at y = 0 they have no energy; sub-steps of h err by the part h/t.
    expect(Math.abs(energy(world).total / energy(world).kinetic)).toBeLessThan(0.005);
  });

  it('a body that never sleeps keeps those on it awake', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
    const crate = (x: number, y: number) =>
      spawn(world, { position: { x, y }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
    const [low, high, other] = [crate(0, 0.5), crate(0, 1.5), crate(5, 0.5)];
    addComponent(world, low, world.components.NeverSleep);
    run(world, 2);
    expect([low, high, other].map((id) => isAsleep(world, id))).toEqual([false, false, true]);
    removeComponent(world, low, world.components.NeverSleep);
    run(world, 2);
    expect(isAsleep(world, high)).toBe(true);
    addComponent(world, high, world.components.NeverSleep);
    step(world, DT);
    expect([low, high].map((id) => isAsleep(world, id))).toEqual([false, false]);
  });
});

test('gravity of a world takes up a scale that is added later, and other integrators know it', () => {
  const world = createPhysicsWorld({ forces: [uniformGravity()], capacity: 10 });
  const body = spawn(world, { position: {}, mass: 1 });
  step(world, 0.5);
  const before = world.components.Velocity.y[body];
  expect(before).toBeCloseTo(-0.5 * G, 5);
  addComponent(world, body, world.components.GravityScale);
  world.components.GravityScale.value[body] = 0;
  step(world, 0.5);
  expect(world.components.Velocity.y[body]).toBe(before);
});

test('a compound with locks and a kinematic compound', () => {
  const world = rigidWorld({ forces: [], integrator: softStep({ sleepTime: 0 }) });
  const parts = [
    { radius: 0.3, density: 1, x: -0.5 },
    { radius: 0.3, density: 1, x: 0.5 },
  ];
  const moving = spawnCompound(world, { velocity: { x: 1 }, angularVelocity: 2, kinematic: {}, parts });
  const locked = spawnCompound(world, { position: { x: 3 }, motionLocks: { x: 1, y: 1, angle: 1 }, parts });
  const before = momentum(world).y;
  run(world, 2);
  const { Position, Rotation } = world.components;
  expect(Position.x[moving.body]).toBeCloseTo(2, 5);
  expect(Rotation.angle[moving.body]).toBeCloseTo(4, 5);
  expect([Position.x[locked.body], Rotation.angle[locked.body]]).toEqual([3, 0]);
  expect(momentum(world).y).toBe(before);
});

test('locks are 0 or 1, and scales are finite', () => {
  const world = rigidWorld();
  const refused = (code: string) => expect.objectContaining({ code });
  expect(() => spawn(world, { position: {}, motionLocks: { x: 2 } })).toThrow(refused('E_RANGE'));
  expect(() => spawn(world, { position: {}, motionLocks: { z: 1 } as never })).toThrow(refused('E_UNKNOWN'));
  expect(() => spawn(world, { position: {}, motionLocks: { x: 'yes' } as never })).toThrow(refused('E_TYPE'));
  expect(() => spawn(world, { position: {}, gravityScale: Number.NaN })).toThrow(refused('E_NONFINITE'));
  expect(() => spawn(world, { position: {}, kinematic: { x: 1 } as never })).toThrow(refused('E_UNKNOWN'));
});

test('a locked body is where it is put, and stays there', () => {
  const world = rigidWorld();
  const body = spawn(world, { position: {}, motionLocks: { x: 1, y: 1 }, collider: { radius: 0.5, density: 1 } });
  run(world, 0.1);
  world.components.Position.x[body] = 7;
  world.components.Velocity.x[body] = 100;
  run(world, 0.5);
  expect([world.components.Position.x[body], world.components.Velocity.x[body]]).toEqual([7, 0]);
});

test('a body is held in the air by velocities of 0 and the mark', () => {
  const world = rigidWorld();
  const falling = spawn(world, { position: { y: 9 }, angularVelocity: 2, collider: { shape: box(1, 1), density: 1 } });
  run(world, 0.5);
  const { Position, Rotation, Velocity, AngularVelocity, Kinematic } = world.components;
  for (const column of [Velocity.x, Velocity.y, AngularVelocity.z]) column[falling] = 0;
  addComponent(world, falling, Kinematic);
  const pose = () => [Position.x[falling], Position.y[falling], Rotation.angle[falling]];
  const before = pose();
  run(world, 1);
  expect(pose()).toEqual(before);
});
