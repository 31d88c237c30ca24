// Joints against their analytic solutions: periods, forces, gaps.
import {
  box,
  createJoint,
  createRandom,
  despawn,
  distance,
  endedJoints,
  energy,
  gear,
  isBody,
  type JointInput,
  jointForce,
  prismatic,
  pulley,
  revolute,
  softStep,
  spawn,
  spawnCompound,
  step,
  weld,
  wheel,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** A body that does not move, without a shape that others could hit. */
const addAnchor = (world: ReturnType<typeof rigidWorld>, x = 0, y = 0) =>
  spawn(world, { position: { x, y }, rotation: 0, collider: { radius: 0.01, mask: 0 } });

/** Distance of the anchors of a joint, m. */
function gapOf(world: ReturnType<typeof rigidWorld>, joint: number): number {
  const { Joint, Position, Rotation } = world.components;
  const place = (body: number, x: number, y: number) => {
    const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
    return [Position.x[body] + c * x - s * y, Position.y[body] + s * x + c * y];
  };
  const a = place(Joint.a[joint], Joint.ax[joint], Joint.ay[joint]);
  const b = place(Joint.b[joint], Joint.bx[joint], Joint.by[joint]);
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

describe.each(['f32', 'f64'] as const)('joints in %s', (precision) => {
  test('a physical pendulum swings with 2π √(I / m g l)', () => {
    const world = rigidWorld({ precision, integrator: softStep({ substeps: 16 }) });
    const anchor = addAnchor(world);
    const length = 1;
    const amplitude = 0.1;
    const [x, y] = [length * Math.sin(amplitude), -length * Math.cos(amplitude)];
    const shape = box(0.2, 0.4);
    const bob = spawn(world, { position: { x, y }, rotation: amplitude, collider: { shape, density: 1 } });
    const joint = createJoint(world, revolute({ a: anchor, b: bob, anchor: {} }));
    const { Rotation, Mass, Inertia } = world.components;
    const mass = Mass.value[bob];
    const period = 2 * Math.PI * Math.sqrt((Inertia.value[bob] + mass * length ** 2) / (mass * G * length));
    const crossings: number[] = [];
    for (let i = 0; i < 900; i++) {
      const before = Rotation.angle[bob];
      step(world, DT);
      const after = Rotation.angle[bob];
      if (before > 0 && after <= 0) crossings.push(world.time - DT + (DT * before) / (before - after));
      expect(gapOf(world, joint)).toBeLessThan(2e-4);
    }
    const measured = (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
    // The period grows with the amplitude by its square over 16.
    expect(Math.abs(measured / (period * (1 + amplitude ** 2 / 16)) - 1)).toBeLessThan(2e-3);
  });

  test('a rod to a fixed point pulls with μ g · u, wherever it is fixed to a box', () => {
    const random = createRandom(5);
    for (let i = 0; i < 40; i++) {
      const world = rigidWorld({ precision, integrator: softStep({ substeps: 1 }) });
      const size = 10 ** random.uniform(-1, 1);
      const shape = box(size, size * random.uniform(0.05, 1));
      const b = spawn(world, { position: {}, rotation: 0, collider: { shape, density: 10 ** random.uniform(-1, 3) } });
      const anchorB = { x: random.uniform(-0.5, 0.5) * size, y: random.uniform(-0.5, 0.5) * size };
      const along = random.uniform(-Math.PI, Math.PI);
      const u = { x: Math.cos(along), y: Math.sin(along) };
      const anchorA = { x: anchorB.x + 3 * size * u.x, y: anchorB.y + 3 * size * u.y };
      const joint = createJoint(world, distance({ b, anchorA, anchorB }));
      step(world, DT);
      const { Mass, Inertia, AngularVelocity } = world.components;
      const arm = anchorB.x * u.y - anchorB.y * u.x;
      const mu = 1 / (1 / Mass.value[b] + arm ** 2 / Inertia.value[b]);
      const pull = mu * G * u.y;
      // Rods to what does not move are a little softer than rigid (hinge-locks.ts), and their direction turns by about g h²/2 over their length.
      const tolerance = (precision === 'f32' ? 1e-4 : 1e-5) * Mass.value[b] * G + (mu * G * G * DT ** 2) / size;
      expect(Math.abs(jointForce(world, joint) - Math.abs(pull))).toBeLessThan(tolerance);
      const turn = (arm * pull * DT) / Inertia.value[b];
      expect(Math.abs(AngularVelocity.z[b] - turn)).toBeLessThan(
        (Math.abs(arm) * tolerance * DT) / Inertia.value[b] + 1e-6,
      );
    }
  });

  test('a box on a rod that is fixed to its corner swings on with its energy', () => {
    const world = rigidWorld({ precision, integrator: softStep({ substeps: 16 }) });
    const shape = box(1.2, 0.2);
    const bob = spawn(world, { position: { x: 0.5 }, rotation: 0, collider: { shape, density: 1 } });
    createJoint(world, distance({ b: bob, anchorA: { x: 3, y: 4 }, anchorB: { x: 1, y: 0 } }));
    const { Position, Velocity, AngularVelocity, Mass, Inertia } = world.components;
    const total = () => {
      const [vx, vy, w] = [Velocity.x[bob], Velocity.y[bob], AngularVelocity.z[bob]];
      const kinetic = (Mass.value[bob] * (vx * vx + vy * vy) + Inertia.value[bob] * w * w) / 2;
      return kinetic + Mass.value[bob] * G * Position.y[bob];
    };
    const fall = Mass.value[bob] * G;
    // First order: a sub-step of h errs by g h at the speeds of a few metres a second.
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      expect(Math.abs(total()) / fall).toBeLessThan(0.15);
    }
  });

  test('a chain of 50 links stretches by less than 1 % under a hundred times the mass of a link', () => {
    const world = rigidWorld({ precision });
    let last = addAnchor(world);
    const joints: number[] = [];
    for (let i = 0; i < 50; i++) {
      const link = spawn(world, { position: { x: 0.1 + 0.2 * i }, collider: { shape: box(0.2, 0.05), density: 100 } });
      joints.push(createJoint(world, revolute({ a: last, b: link, anchor: { x: 0.2 * i } })));
      last = link;
    }
    const ball = spawn(world, { position: { x: 10 }, rotation: 0, angularVelocity: 0, mass: 100, inertia: 10 });
    joints.push(createJoint(world, revolute({ a: last, b: ball, anchor: { x: 10 } })));
    let worst = 0;
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      let stretch = 0;
      for (const joint of joints) stretch += gapOf(world, joint);
      worst = Math.max(worst, stretch);
    }
    expect(worst).toBeLessThan(0.01 * 10);
    const { x, y } = world.components.Position;
    expect(Math.hypot(x[ball], y[ball])).toBeLessThan(10.1);
  });

  test('a bridge between two pillars holds, and a ring of links stays closed', () => {
    const world = rigidWorld({ precision });
    const joints: number[] = [];
    let last = addAnchor(world);
    for (let i = 0; i < 20; i++) {
      const plank = spawn(world, { position: { x: 0.25 + 0.5 * i }, collider: { shape: box(0.5, 0.1), density: 20 } });
      joints.push(createJoint(world, revolute({ a: last, b: plank, anchor: { x: 0.5 * i } })));
      last = plank;
    }
    joints.push(createJoint(world, revolute({ a: last, b: addAnchor(world, 10), anchor: { x: 10 } })));
    const ring: number[] = [];
    for (let i = 0; i < 8; i++) {
      const angle = (i / 8) * 2 * Math.PI;
      const position = { x: 20 + Math.cos(angle), y: Math.sin(angle) };
      ring.push(spawn(world, { position, rotation: angle, collider: { shape: box(0.2, 0.7), density: 1 } }));
    }
    for (const [i, a] of ring.entries()) {
      const angle = ((i + 0.5) / 8) * 2 * Math.PI;
      const anchor = { x: 20 + 1.05 * Math.cos(angle), y: 1.05 * Math.sin(angle) };
      joints.push(createJoint(world, revolute({ a, b: ring[(i + 1) % 8], anchor })));
    }
    run(world, 5);
    // A straight bridge must sag: its tension is several hundred times the weight of a plank at first.
    for (const joint of joints) expect(gapOf(world, joint)).toBeLessThan(0.005);
  });

  it('holds a beam by a weld, with the force m g', () => {
    const world = rigidWorld({ precision });
    const wall = addAnchor(world);
    const beam = spawn(world, { position: { x: 1 }, collider: { shape: box(2, 0.2), density: 10 } });
    const joint = createJoint(world, weld({ a: wall, b: beam, anchor: {} }));
    run(world, 2);
    expect(Math.abs(world.components.Rotation.angle[beam])).toBeLessThan(1e-3);
    expect(jointForce(world, joint) / (4 * G)).toBeCloseTo(1, 2);
  });

  it('slides along an axis with g sin θ, and stops at the limit', () => {
    const world = rigidWorld({ precision });
    const rail = addAnchor(world);
    const slider = spawn(world, { collider: { shape: box(0.5, 0.5), density: 1 }, position: {} });
    const axis = { x: Math.cos(-0.5), y: Math.sin(-0.5) };
    createJoint(world, prismatic({ a: rail, b: slider, anchor: {}, axis, limits: { upper: 3 } }));
    run(world, 0.5);
    const { Position, Velocity, Rotation } = world.components;
    const along = () => Position.x[slider] * axis.x + Position.y[slider] * axis.y;
    const speed = Math.hypot(Velocity.x[slider], Velocity.y[slider]);
    expect(speed / (G * Math.sin(0.5) * 0.5)).toBeCloseTo(1, 3);
    run(world, 3);
    expect(Math.abs(along() - 3)).toBeLessThan(0.005);
    expect(Math.abs(Rotation.angle[slider])).toBeLessThan(1e-4);
  });

  it('hangs on a spring m g / k lower, and on a rope as long as that is', () => {
    const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
    const ceiling = addAnchor(world);
    const body = spawn(world, { position: { y: -1 }, mass: 2 });
    createJoint(world, distance({ a: ceiling, b: body, spring: { hertz: 1, dampingRatio: 1 } }));
    const other = spawn(world, { position: { x: 5, y: -1 }, mass: 2 });
    createJoint(world, distance({ a: addAnchor(world, 5), b: other, limits: { upper: 3 } }));
    run(world, 10);
    // ω² = k/m, so that m g / k = g / ω².
    expect(world.components.Position.y[body]).toBeCloseTo(-1 - G / (2 * Math.PI) ** 2, 3);
    expect(Math.abs(world.components.Position.y[other] + 3)).toBeLessThan(0.005);
  });

  it('turns a wheel by its motor with the torque over the inertia', () => {
    const world = rigidWorld({ precision, forces: [] });
    const chassis = spawn(world, { position: {}, rotation: 0, angularVelocity: 0, mass: 1e6, inertia: 1e6 });
    const tire = spawn(world, { position: { y: -1 }, collider: { shape: box(1, 1), density: 6 } });
    createJoint(world, wheel({ a: chassis, b: tire, anchor: { y: -1 }, motor: { speed: -20, max: 2 } }));
    run(world, 1);
    expect(world.components.AngularVelocity.z[tire]).toBeCloseTo(-2 / 1, 3);
    run(world, 20);
    expect(world.components.AngularVelocity.z[tire]).toBeCloseTo(-20, 2);
  });
});

test('a joint breaks at its force, and goes with its body', () => {
  const world = rigidWorld();
  const ceiling = addAnchor(world);
  const make = (breakForce: number) => {
    const body = spawn(world, { position: { y: -1 }, mass: 1 });
    return [body, createJoint(world, distance({ a: ceiling, b: body, breakForce }))];
  };
  const [light, weak] = make(0.9 * G);
  const [heavy, strong] = make(2 * G);
  step(world, DT);
  expect(endedJoints(world).broken).toEqual([weak]);
  run(world, 1);
  expect(world.components.Position.y[light]).toBeLessThan(-3);
  expect(world.components.Position.y[heavy]).toBeCloseTo(-1, 3);
  despawn(world, heavy);
  step(world, DT);
  expect(endedJoints(world).removed).toEqual([strong]);
  expect(isBody(world, strong)).toBe(false);
  expect(world.internal.counts.Joint).toBe(0);
});

test('bodies of a joint pass through each other, unless they are told to collide', () => {
  for (const collide of [false, true]) {
    const world = rigidWorld({ forces: [] });
    const a = spawn(world, { position: {}, collider: { radius: 0.5, density: 1 } });
    const b = spawn(world, { position: { x: 2 }, velocity: { x: -1 }, collider: { radius: 0.5, density: 1 } });
    createJoint(world, prismatic({ a, b, anchor: { x: 2 }, axis: { x: 1 }, collide }));
    run(world, 1.5);
    expect(world.components.Velocity.x[a] !== 0).toBe(collide);
  }
});

test('bodies collide again when the joint between them is gone', () => {
  const world = rigidWorld({ forces: [] });
  const [a, b] = [0, 0.6].map((x) => spawn(world, { position: { x }, collider: { radius: 0.5, density: 1 } }));
  const joint = createJoint(world, weld({ a, b, anchor: {} }));
  const { x } = world.components.Position;
  run(world, 0.2);
  expect(x[b] - x[a]).toBeCloseTo(0.6, 6);
  despawn(world, joint);
  run(world, 2);
  expect(x[b] - x[a]).toBeGreaterThan(0.99);
});

test('a joint to a part of a compound body is one to its body, at the part', () => {
  const plate = { shape: box(0.4, 0.2), density: 1 };
  const swing = (toPart: boolean) => {
    const world = rigidWorld();
    const hammer = spawnCompound(world, { rotation: 0.4, parts: [plate, { ...plate, x: 1, y: 0.3 }] });
    world.components.Position.x[hammer.body] += 2;
    const { x, y } = world.components.Position;
    // Where the part is after the body was moved, which its own columns show at the end of the next step.
    const anchorB = { x: x[hammer.parts[1]] + 2, y: y[hammer.parts[1]] };
    const a = addAnchor(world, 3, 4);
    const joint = toPart ? distance({ a, b: hammer.parts[1] }) : distance({ a, b: hammer.body, anchorB });
    const id = createJoint(world, joint);
    expect(world.components.Joint.b[id]).toBe(hammer.body);
    run(world, 1);
    const length = Math.hypot(anchorB.x - 3, anchorB.y - 4);
    expect(Math.hypot(x[hammer.parts[1]] - 3, y[hammer.parts[1]] - 4)).toBeCloseTo(length, 3);
    return world.components.Rotation.angle[hammer.body];
  };
  // The two places of the part differ by rounding, which the swings amplify.
  expect(Math.abs(swing(true) - swing(false))).toBeLessThan(1e-6);
  const world = rigidWorld();
  const { parts } = spawnCompound(world, { parts: [plate, { ...plate, x: 1 }] });
  expect(() => createJoint(world, weld({ a: parts[0], b: parts[1], anchor: {} }))).toThrow(
    expect.objectContaining({ code: 'E_RANGE' }),
  );
});

test('a faulty joint is refused and changes nothing', () => {
  const world = rigidWorld();
  const a = addAnchor(world);
  const b = spawn(world, { position: {}, mass: 1 });
  const count = world.internal.counts.Joint;
  const faulty: [() => JointInput, string][] = [
    [() => revolute({ a, b: 77, anchor: {} }), 'E_STALE'],
    [() => revolute({ a: b, b, anchor: {} }), 'E_RANGE'],
    [() => revolute({ a, b, anchor: {}, limits: { lower: 1, upper: -1 } }), 'E_RANGE'],
    [() => distance({ a, b, length: -1 }), 'E_RANGE'],
    [() => prismatic({ a, b, anchor: {}, axis: {} }), 'E_RANGE'],
    [() => gear({ a, b, ratio: 0 }), 'E_RANGE'],
    [() => pulley({ a, b, pulleyA: {}, pulleyB: {}, ratio: -1 }), 'E_RANGE'],
    [() => weld({ a, b, anchor: { x: Number.NaN } }), 'E_NONFINITE'],
  ];
  for (const [make, code] of faulty)
    expect(() => createJoint(world, make())).toThrow(expect.objectContaining({ code }));
  expect(world.internal.counts.Joint).toBe(count);
});

test('a spring of a joint has the stiffness (2π f)² times the reduced mass, and no more damping than it is given', () => {
  const world = rigidWorld({ forces: [] });
  const free = (x: number, mass: number) =>
    spawn(world, { position: { x }, mass, neverSleep: {}, collider: { radius: 0.1 } });
  const [a, b] = [free(0, 3), free(1.1, 1)];
  const hertz = 1;
  createJoint(world, distance({ a, b, length: 1, spring: { hertz, dampingRatio: 0 } }));
  const { Position } = world.components;
  const extensions: number[] = [];
  for (let i = 0; i < 120; i++) {
    step(world, DT);
    extensions.push(Position.x[b] - Position.x[a] - 1);
  }
  const period = 1 / hertz / DT;
  expect(extensions[period - 1]).toBeCloseTo(0.1, 4);
  expect(extensions[2 * period - 1]).toBeCloseTo(0.1, 4);
});

test.each([1, 3])('a damped spring of %d Hz swings out by its damping ratio', (hertz) => {
  const world = rigidWorld({ forces: [] });
  const b = spawn(world, { position: { x: 1.1 }, mass: 2, neverSleep: {}, collider: { radius: 0.1 } });
  createJoint(world, distance({ b, anchorA: {}, length: 1, spring: { hertz, dampingRatio: 0.2 } }));
  const { x } = world.components.Position;
  const [omega, h] = [2 * Math.PI * hertz, DT / 4];
  const damped = omega * Math.sqrt(1 - 0.2 ** 2);
  for (let i = 1; i <= 60; i++) {
    step(world, DT);
    const t = i * DT;
    const exact =
      0.1 *
      Math.exp(-0.2 * omega * t) *
      (Math.cos(damped * t) + (0.2 / Math.sqrt(1 - 0.2 ** 2)) * Math.sin(damped * t));
    // First order in the phase: half a sub-step.
    expect(Math.abs(x[b] - 1 - exact)).toBeLessThan(0.1 * ((omega * h) / 2 + 1e-3));
  }
});

test('a spring that is too fast for the sub-steps is damped, and stays stable', () => {
  const world = rigidWorld();
  const b = spawn(world, { position: { x: 1.1 }, mass: 2, neverSleep: {}, collider: { radius: 0.1 } });
  createJoint(world, distance({ b, anchorA: { y: 1 }, spring: { hertz: 500, dampingRatio: 0 } }));
  const start = energy(world).total;
  for (let i = 0; i < 600; i++) {
    step(world, DT);
    // It begins at rest and without tension, so that no time has more; speeds are those of half a sub-step ago.
    const speed = Math.hypot(world.components.Velocity.x[b], world.components.Velocity.y[b]);
    expect(energy(world).total).toBeLessThan(start + 2 * G * speed * (DT / 8) + 1e-9);
  }
});

test('a joint to the world is copied by its columns', () => {
  const world = rigidWorld();
  const [one, other] = [1, 5].map((x) => spawn(world, { position: { x }, collider: { shape: box(1, 1), density: 1 } }));
  const joint = createJoint(world, revolute({ b: one, anchor: {} }));
  const { Joint, Position } = world.components;
  const columns = Joint as unknown as Record<string, ArrayLike<number>>;
  const fields = Object.keys(columns).filter((field) => !/Generation|started/.test(field));
  const values = Object.fromEntries(fields.map((field) => [field, columns[field][joint]]));
  expect(values.a).toBe(0);
  // The other hangs 4 m further on, at its own anchor.
  spawn(world, { joint: { ...values, b: other, ax: 4 } });
  run(world, 1);
  expect(Position.x[other] - Position.x[one]).toBeCloseTo(4, 6);
  expect(Position.y[other]).toBeCloseTo(Position.y[one], 6);
  expect(Math.hypot(Position.x[one], Position.y[one])).toBeCloseTo(1, 3);
});
