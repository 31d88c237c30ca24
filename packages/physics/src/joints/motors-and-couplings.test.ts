// Motor joints, pulleys, gears and filters against their analytic solutions.
import {
  asleepCount,
  box,
  createJoint,
  endedJoints,
  filterJoint,
  gear,
  jointForce,
  jointTorque,
  motorJoint,
  mouseJoint,
  type PhysicsWorldOptions,
  prismatic,
  pulley,
  revolute,
  softStep,
  spawn,
  step,
  uniformGravity,
  weld,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const G = 10;

/** With round numbers. */
function worldOfTen(options: PhysicsWorldOptions = {}) {
  return rigidWorld({ forces: [uniformGravity({ y: -G })], ...options });
}

/** A disc of 1 kg whose moment of inertia is 0.5 kg m² for a radius of 1 m. */
const disc = (world: ReturnType<typeof worldOfTen>, x: number, y: number, mass = 1) =>
  spawn(world, {
    position: { x, y },
    rotation: 0,
    angularVelocity: 0,
    mass,
    inertia: 0.5 * mass,
    collider: { radius: 1, mask: 0 },
  });

describe.each(['f32', 'f64'] as const)('couplings in %s', (precision) => {
  // Sub-steps of semi-implicit Euler with constant acceleration: v is exact, x is off by a t h / 2.
  const h = DT / 4;
  const digits = precision === 'f32' ? 1e-4 : 1e-9;

  test("Atwood's machine: a = g (m₁ - m₂)/(m₁ + m₂), and the tension 2 m₁ m₂ g/(m₁ + m₂)", () => {
    const world = worldOfTen({ precision });
    const a = disc(world, -2, 0, 3);
    const b = disc(world, 2, 0, 1);
    const rope = createJoint(world, pulley({ a, b, pulleyA: { x: -2, y: 10 }, pulleyB: { x: 2, y: 10 } }));
    run(world, 1);
    const acceleration = (G * (3 - 1)) / (3 + 1);
    const { Position, Velocity } = world.components;
    expect(Math.abs(Velocity.y[a] + acceleration)).toBeLessThan(10 * digits);
    expect(Math.abs(Velocity.y[b] - acceleration)).toBeLessThan(10 * digits);
    // Until the rope pulls, in the first sub-step, a body falls by g h².
    expect(Math.abs(Position.y[b] - 0.5 * acceleration * (1 + h))).toBeLessThan(G * h * h);
    // The tension swings about its value for a few sub-steps when the joint begins.
    step(world, DT);
    expect(Math.abs(jointForce(world, rope) / ((2 * 3 * 1 * G) / 4) - 1)).toBeLessThan(1e-3);
  });

  test('a block and tackle: half the weight on the side with twice the rope holds the balance', () => {
    const world = worldOfTen({ precision });
    const a = disc(world, -2, 0, 1);
    const b = disc(world, 2, 0, 2);
    const ends = { pulleyA: { x: -2, y: 10 }, pulleyB: { x: 2, y: 10 } };
    const rope = createJoint(world, pulley({ a, b, ratio: 2, ...ends }));
    run(world, 2);
    expect(Math.abs(world.components.Position.y[a])).toBeLessThan(1e-3);
    expect(Math.abs(world.components.Position.y[b])).toBeLessThan(1e-3);
    // The force on b, which bears 2 kg.
    expect(Math.abs(jointForce(world, rope) / (2 * G) - 1)).toBeLessThan(1e-3);
  });

  test('the rope of a pulley pulls and never pushes', () => {
    const world = worldOfTen({ precision, forces: [] });
    const a = disc(world, -2, 0);
    const b = disc(world, 2, 0);
    const wheels = { pulleyA: { x: -2, y: 10 }, pulleyB: { x: 2, y: 10 } };
    const rope = createJoint(world, pulley({ a, b, ...wheels, length: 25 }));
    world.components.Velocity.y[a] = 1;
    run(world, 1);
    expect(world.components.Velocity.y[b]).toBe(0);
    expect(jointForce(world, rope)).toBe(0);
  });

  test('two gears share a torque: α = τ/(I_a + ratio² I_b)', () => {
    const world = worldOfTen({ precision });
    const a = disc(world, -5, 0, 2);
    const b = disc(world, 5, 0, 1);
    for (const [body, x] of [
      [a, -5],
      [b, 5],
    ])
      createJoint(world, revolute({ b: body, anchor: { x } }));
    const drive = createJoint(world, revolute({ b: a, anchor: { x: -5 }, motor: { speed: 1e6, max: 4 } }));
    createJoint(world, gear({ a, b, ratio: -2 }));
    run(world, 1);
    const { AngularVelocity, Rotation } = world.components;
    const expected = 4 / (1 + 4 * 0.5);
    expect(Math.abs(AngularVelocity.z[a] / expected - 1)).toBeLessThan(2e-3);
    expect(Math.abs(AngularVelocity.z[b] / AngularVelocity.z[a] + 2)).toBeLessThan(2e-3);
    expect(Math.abs(Rotation.angle[b] + 2 * Rotation.angle[a])).toBeLessThan(1e-3);
    expect(Math.abs(jointTorque(world, drive) / 4 - 1)).toBeLessThan(1e-3);
  });

  test('a rack moves by the radius of its pinion for each radian', () => {
    const world = worldOfTen({ precision, forces: [] });
    const pinion = disc(world, 0, 1);
    const rack = spawn(world, { position: { x: 3 }, collider: { shape: box(6, 0.2), density: 1, mask: 0 } });
    createJoint(world, revolute({ b: pinion, anchor: { y: 1 }, motor: { speed: 3, max: 1000 } }));
    createJoint(world, prismatic({ b: rack, anchor: { x: 3 }, axis: { x: 1 } }));
    createJoint(world, gear({ a: pinion, b: rack, ratio: 0.5, axis: { x: 1 } }));
    run(world, 2);
    const { Position, Rotation } = world.components;
    expect(Rotation.angle[pinion]).toBeGreaterThan(5.5);
    expect(Math.abs(Position.x[rack] - 3 - 0.5 * Rotation.angle[pinion])).toBeLessThan(1e-3);
  });
});

describe.each(['f32', 'f64'] as const)('motor joints in %s', (precision) => {
  test('the mouse holds a body below its target by m g / k, with k = m (2 π f)²', () => {
    const world = worldOfTen({ precision, integrator: softStep({ sleepTime: 0 }) });
    const body = disc(world, 1, 1, 2);
    createJoint(world, mouseJoint({ b: body, target: { x: 3, y: 4 }, spring: { hertz: 2 }, maxForce: 1000 }));
    run(world, 6);
    const { Position } = world.components;
    // The spring is implicit, and exact where nothing moves.
    expect(Math.abs(Position.x[body] - 3)).toBeLessThan(1e-3);
    expect(Math.abs(4 - Position.y[body] - G / (2 * Math.PI * 2) ** 2)).toBeLessThan(1e-3);
  });

  test('the force is limited: a body that is too heavy falls with g - F/m', () => {
    const world = worldOfTen({ precision });
    const body = disc(world, 0, 0, 2);
    const joint = createJoint(world, mouseJoint({ b: body, target: { y: 50 }, spring: { hertz: 5 }, maxForce: 8 }));
    run(world, 1);
    expect(Math.abs(world.components.Velocity.y[body] + (G - 8 / 2))).toBeLessThan(1e-3);
    expect(jointForce(world, joint)).toBeLessThan(8 * (1 + 1e-6));
  });

  test('without a spring it is the friction of a floor seen from above: v falls by F/m, ω by τ/I', () => {
    const world = worldOfTen({ precision, forces: [] });
    const body = disc(world, 0, 0, 2);
    const { Velocity, AngularVelocity } = world.components;
    Velocity.x[body] = 5;
    AngularVelocity.z[body] = 3;
    createJoint(world, motorJoint({ b: body, spring: { hertz: 0 }, maxForce: 4, maxTorque: 1 }));
    run(world, 1);
    expect(Math.abs(Velocity.x[body] - (5 - 4 / 2))).toBeLessThan(1e-4);
    expect(Math.abs(AngularVelocity.z[body] - (3 - 1 / 1))).toBeLessThan(1e-4);
    run(world, 3);
    expect(Math.abs(Velocity.x[body])).toBeLessThan(1e-6);
  });

  test('a motor joint follows a moving body, to the offset and the angle that were asked for', () => {
    const world = worldOfTen({ precision, forces: [] });
    const cart = spawn(world, { position: {}, velocity: { x: 2 }, rotation: 0, collider: { radius: 0.1, mask: 0 } });
    const drone = disc(world, 5, 5);
    const joint = { a: cart, b: drone, target: { x: 0, y: 3 }, turn: 0.5, spring: { hertz: 2 } };
    createJoint(world, motorJoint({ ...joint, maxForce: 1e4, maxTorque: 1e4 }));
    run(world, 5);
    const { Position, Rotation } = world.components;
    expect(Math.abs(Position.x[drone] - Position.x[cart])).toBeLessThan(0.01);
    expect(Math.abs(Position.y[drone] - 3)).toBeLessThan(0.01);
    expect(Math.abs(Rotation.angle[drone] - 0.5)).toBeLessThan(1e-3);
  });

  test('a motor joint without a target leaves b where it is, and takes it along with a', () => {
    const world = worldOfTen({ precision, forces: [] });
    const { Position, Velocity } = world.components;
    const cart = spawn(world, { position: {}, velocity: {}, rotation: 0, collider: { radius: 0.1, mask: 0 } });
    const drone = disc(world, 1.5, 0.25);
    createJoint(world, motorJoint({ a: cart, b: drone, spring: { hertz: 2 }, maxForce: 1e4, maxTorque: 1e4 }));
    run(world, 2);
    expect([Position.x[drone], Position.y[drone]]).toEqual([1.5, 0.25]);
    Velocity.x[cart] = 1;
    run(world, 5);
    expect(Math.abs(Position.x[drone] - Position.x[cart] - 1.5)).toBeLessThan(0.01);
    expect(Math.abs(Position.y[drone] - 0.25)).toBeLessThan(1e-6);
  });

  test('a body that sleeps wakes when the target of its mouse joint moves', () => {
    const world = worldOfTen({ precision });
    spawn(world, { position: { y: -1 }, collider: { shape: box(20, 2) } });
    const crate = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });
    const joint = createJoint(world, mouseJoint({ b: crate, target: { y: 0.5 }, maxForce: 100 }));
    run(world, 2);
    expect(asleepCount(world)).toBe(1);
    world.components.Joint.ay[joint] = 3;
    run(world, 2);
    expect(world.components.Position.y[crate]).toBeGreaterThan(2.5);
  });
});

describe('the world as a body', () => {
  test('a joint without a holds b to the world, as a static body would, to the bit', () => {
    const positions = [true, false].map((isAnchored) => {
      const world = worldOfTen();
      const anchor = spawn(world, { position: {}, collider: { radius: 0.01, mask: 0 } });
      const bob = spawn(world, { position: { x: 1 }, collider: { shape: box(0.2, 0.2), density: 1 } });
      createJoint(world, revolute({ b: bob, anchor: {}, ...(isAnchored ? { a: anchor } : {}) }));
      run(world, 2);
      return [world.components.Position.x[bob], world.components.Position.y[bob]];
    });
    expect(positions[0]).toEqual(positions[1]);
  });

  test('a filter joint keeps two bodies from colliding, and joins nothing', () => {
    const world = worldOfTen();
    const ground = spawn(world, { position: { y: -1 }, collider: { shape: box(20, 2) } });
    const [ghost, crate] = [0, 5].map((x) =>
      spawn(world, { position: { x, y: 0.5 }, collider: { shape: box(1, 1), density: 1 } }),
    );
    createJoint(world, filterJoint({ a: ground, b: ghost }));
    run(world, 1);
    expect(Math.abs(world.components.Velocity.y[ghost] + G)).toBeLessThan(1e-6);
    expect(Math.abs(world.components.Position.y[crate] - 0.5)).toBeLessThan(0.01);
  });

  test('a weld breaks at its torque', () => {
    const world = worldOfTen();
    const plank = spawn(world, { position: { x: 1 }, collider: { shape: box(2, 0.1), density: 10 } });
    // Its weight of 2 kg · g acts 1 m from the weld.
    const strong = createJoint(world, weld({ b: plank, anchor: {}, breakTorque: 40 }));
    run(world, 1);
    expect(Math.abs(jointTorque(world, strong) / 20 - 1)).toBeLessThan(0.02);
    world.components.Joint.breakTorque[strong] = 15;
    run(world, 0.1);
    expect(world.components.Velocity.y[plank]).toBeLessThan(-0.5);
    expect(endedJoints(world).broken).toEqual([]);
  });
});

describe('bad input', () => {
  const world = worldOfTen();
  const body = disc(world, 0, 0);
  test.each([
    ['no limit of force', () => mouseJoint({ b: body, target: {} } as never), 'mouseJoint.maxForce'],
    ['no limit of torque', () => motorJoint({ b: body, maxForce: 1 } as never), 'motorJoint.maxTorque'],
    ['an infinite force', () => mouseJoint({ b: body, target: {}, maxForce: Infinity }), 'mouseJoint.maxForce'],
    ['a gear without a', () => gear({ b: body, ratio: 1 } as never), 'gear.a'],
    ['a gear with a ratio of NaN', () => gear({ a: body, b: body, ratio: Number.NaN }), 'gear.ratio'],
    [
      'a pulley with itself',
      () => createJoint(world, pulley({ a: body, b: body, pulleyA: {}, pulleyB: {} })),
      'joint.b',
    ],
    ['an unknown option', () => filterJoint({ a: body, b: 2, force: 3 } as never), 'force'],
  ])('%s is refused by name', (_, act, field) => {
    expect(act).toThrow(expect.objectContaining({ field: expect.stringContaining(field) }));
  });
});
