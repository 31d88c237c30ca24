// Compound bodies: mass properties by the parallel-axis theorem, and motion as one body.
import {
  angularMomentum,
  bodyOf,
  box,
  type CompoundShape,
  contactEvents,
  createJoint,
  createPhysicsWorld,
  despawn,
  isBody,
  momentum,
  overlapShape,
  partsOf,
  polygon,
  rayCast,
  restore,
  revolute,
  segment,
  snapshot,
  softStep,
  spawn,
  spawnCompound,
  spawnMany,
  stateHash,
  step,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const refused = (code: string) => expect.objectContaining({ code });

describe('mass properties', () => {
  it('of a dumbbell: 2 (m r²/2 + m d²), and its centre lies nearer to the heavier ball', () => {
    const world = rigidWorld({ precision: 'f64' });
    const [m, r, d] = [3, 0.2, 1];
    const density = m / (Math.PI * r * r);
    const ball = { radius: r, density };
    const { body, parts } = spawnCompound(world, {
      position: { y: 5 },
      parts: [
        { ...ball, x: -d },
        { ...ball, x: d },
      ],
    });
    const { Mass, Inertia, Position } = world.components;
    expect(Mass.value[body]).toBeCloseTo(2 * m, 12);
    expect(Inertia.value[body]).toBeCloseTo(2 * (0.5 * m * r * r + m * d * d), 12);
    expect([Position.x[body], Position.y[body]]).toEqual([0, 5]);
    expect(parts.map((part) => Position.x[part])).toEqual([-d, d]);

    const uneven = spawnCompound(world, {
      position: { x: 10 },
      rotation: Math.PI / 2,
      parts: [
        { ...ball, x: 0 },
        { ...ball, x: 4 * d, density: 3 * density },
      ],
    });
    // The centre divides the distance 1 : 3, and the x axis of the compound points along y of the world.
    expect(Position.x[uneven.body]).toBeCloseTo(10, 12);
    expect(Position.y[uneven.body]).toBeCloseTo(3 * d, 12);
    expect(Position.y[uneven.parts[1]]).toBeCloseTo(4 * d, 12);
    const reduced = (m * 3 * m) / (4 * m);
    expect(Inertia.value[uneven.body]).toBeCloseTo(0.5 * 4 * m * r * r + reduced * 16 * d * d, 10);
  });

  it('scale to a mass that is given, and follow from the areas without densities', () => {
    const world = rigidWorld({ precision: 'f64' });
    const halves = [
      { shape: box(1, 1), x: -0.5 },
      { shape: box(1, 1), x: 0.5 },
    ];
    const { body } = spawnCompound(world, { mass: 6, parts: halves });
    expect(world.components.Inertia.value[body]).toBeCloseTo((6 * (4 + 1)) / 12, 12);
    const still = spawnCompound(world, { position: { x: 9 }, parts: halves });
    expect(world.components.Mass.value[still.body]).toBe(0);
  });
});

describe.each(['f32', 'f64'] as const)('a compound in %s', (precision) => {
  it('moves as one polygon when two half-boxes make a box', () => {
    const collide = { friction: 0.6, density: 2 };
    const build = (isCompound: boolean) => {
      const world = rigidWorld({ precision });
      spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
      const pose = { position: { y: 1.2 }, rotation: 0.3, velocity: { x: 1 }, angularVelocity: 0.5 };
      const parts = [
        { shape: box(0.5, 0.5), x: -0.25, ...collide },
        { shape: box(0.5, 0.5), x: 0.25, ...collide },
      ];
      const body = isCompound
        ? spawnCompound(world, { ...pose, parts }).body
        : spawn(world, { ...pose, collider: { shape: box(1, 0.5), ...collide } });
      return { world, body };
    };
    const [compound, single] = [build(true), build(false)];
    for (const { world } of [compound, single]) run(world, 0.35);
    const read = ({ world, body }: typeof single) => {
      const { Position, Velocity, Rotation } = world.components;
      return [Position.x[body], Position.y[body], Rotation.angle[body], Velocity.x[body], Velocity.y[body]];
    };
    // In flight and at the first corner they are the same; then contacts lie on the halves, and only rest is.
    for (const [i, value] of read(compound).entries()) expect(value).toBeCloseTo(read(single)[i], 2);
    for (const { world } of [compound, single]) run(world, 4);
    expect(read(compound)[1]).toBeCloseTo(0.25, 2);
    expect(read(single)[1]).toBeCloseTo(0.25, 2);
    expect(Math.abs(read(compound)[2])).toBeLessThan(0.01);
  });

  it('swings as a physical pendulum: T = 2π √(I / m g l)', () => {
    const world = rigidWorld({ precision, integrator: softStep({ substeps: 16, sleepTime: 0 }) });
    // A T: a bar under the pivot, and a crossbar at its lower end.
    const parts: CompoundShape[] = [
      { shape: box(0.1, 1), y: -0.5, density: 10 },
      { shape: box(0.8, 0.1), y: -1.05, density: 10 },
    ];
    const { body } = spawnCompound(world, { parts });
    const { Position, Inertia, Mass, Rotation } = world.components;
    const length = -Position.y[body];
    const inertia = Inertia.value[body] + Mass.value[body] * length * length;
    const period = 2 * Math.PI * Math.sqrt(inertia / (Mass.value[body] * G * length));
    const pivot = spawn(world, { position: { x: 0, y: 0 } });
    createJoint(world, revolute({ a: pivot, b: body, anchor: { x: 0, y: 0 } }));
    world.components.AngularVelocity.z[body] = 0.1;
    world.components.Velocity.x[body] = 0.1 * length;
    const crossings: number[] = [];
    for (let i = 0; i < 60 * 12; i++) {
      const before = Rotation.angle[body];
      step(world, DT);
      const after = Rotation.angle[body];
      if (before < 0 && after >= 0) crossings.push((i - before / (after - before)) * DT);
    }
    const measured = (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
    // Semi-implicit Euler of h = 1/960 s errs by (ω h)²/24, the interpolation between steps by less than 1e-3.
    expect(measured / period).toBeCloseTo(1, 2);
  });

  it('keeps momentum and angular momentum in a free collision', () => {
    const world = rigidWorld({ precision, forces: [] });
    const bar = { shape: box(1, 0.2), density: 2, restitution: 0.5, friction: 0.4 };
    const parts = [bar, { ...bar, x: 0.5, y: 0.5, angle: 1.2 }];
    spawnCompound(world, { position: { x: -1.5 }, velocity: { x: 3 }, angularVelocity: 1, parts });
    spawnCompound(world, { position: { x: 1.5, y: 0.3 }, velocity: { x: -2 }, parts });
    const read = () => [momentum(world).x, momentum(world).y, angularMomentum(world).z];
    const before = read();
    run(world, 2);
    const after = read();
    const epsilon = precision === 'f32' ? 1e-5 : 1e-12;
    expect(Math.abs(after[0] - before[0])).toBeLessThan(10 * epsilon);
    expect(Math.abs(after[1] - before[1])).toBeLessThan(10 * epsilon);
    // Anchors are those of the start of the step: angular momentum errs by the turn within a step.
    expect(Math.abs(after[2] - before[2])).toBeLessThan(0.1);
  });

  it('carries its parts rigidly, and rests and sleeps with them', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
    const leg = { shape: box(0.2, 1), density: 5, friction: 0.6 };
    const { body, parts } = spawnCompound(world, {
      position: { y: 0.6 },
      rotation: 0.05,
      parts: [
        { ...leg, x: -0.9 },
        { ...leg, x: 0.9 },
        { shape: box(2, 0.2), y: 0.6, density: 5, friction: 0.6 },
      ],
    });
    run(world, 3);
    const { Position, Rotation, Attachment } = world.components;
    for (const part of parts) {
      const angle = Rotation.angle[body];
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const [x, y] = [Attachment.x[part], Attachment.y[part]];
      expect(Position.x[part]).toBeCloseTo(Position.x[body] + c * x - s * y, 5);
      expect(Position.y[part]).toBeCloseTo(Position.y[body] + s * x + c * y, 5);
    }
    expect(Position.y[parts[0]]).toBeCloseTo(0.5, 2);
    const at = Position.y[body];
    run(world, 1);
    expect(Position.y[body]).toBe(at);
    despawn(world, parts[0]);
    run(world, 1);
    // Without a leg it wakes and tips over.
    expect(Math.abs(Rotation.angle[body])).toBeGreaterThan(0.2);
    expect(partsOf(world, body)).toEqual([parts[1], parts[2]]);
  });

  it('does not pass through thin ground with any of its parts', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: {}, collider: { shape: segment({ x: -20 }, { x: 20 }) } });
    const { body, parts } = spawnCompound(world, {
      position: { y: 10 },
      velocity: { y: -400 },
      parts: [
        { radius: 0.05, density: 1, x: -1 },
        { radius: 0.05, density: 1, x: 1 },
      ],
    });
    run(world, 1);
    for (const part of [body, ...parts]) expect(world.components.Position.y[part]).toBeGreaterThan(-0.01);
  });
});

test('events and queries name the part; its body is read by bodyOf', () => {
  const world = rigidWorld();
  const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1) } });
  const { body, parts } = spawnCompound(world, {
    position: { y: 0.55 },
    parts: [
      { shape: box(1, 1), density: 1 },
      { shape: box(1, 1), y: 1, density: 1 },
    ],
  });
  expect(rayCast(world, { x: -5, y: 1.5 }, { x: 5, y: 1.5 })?.body).toBe(parts[1]);
  world.components.Position.x[body] = 3;
  expect(overlapShape(world, box(0.1, 0.1), { x: 3, y: 1.5 })).toEqual([parts[1]]);
  let begun: number[] = [];
  for (let i = 0; i < 60 && begun.length === 0; i++) {
    step(world, DT);
    const { begin } = contactEvents(world);
    if (begin.count > 0) begun = [begin.a[0], begin.b[0]];
  }
  expect(begun).toEqual([ground, parts[0]]);
  expect([bodyOf(world, parts[0]), bodyOf(world, ground)]).toEqual([body, ground]);
});

test('parts go with their body, in a step and between two, and others take their ids', () => {
  const world = rigidWorld();
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1) } });
  const build = () =>
    spawnCompound(world, {
      position: { y: 1 },
      parts: [
        { radius: 0.5, density: 1 },
        { radius: 0.5, x: 1 },
      ],
    });
  const first = build();
  run(world, 0.2);
  despawn(world, first.body);
  for (const part of first.parts) expect(isBody(world, part)).toBe(false);
  const second = build();
  const remove = () => despawn(world, second.body);
  world.phases.finish.push(remove);
  step(world, DT);
  world.phases.finish.splice(world.phases.finish.indexOf(remove), 1);
  for (const part of second.parts) expect(isBody(world, part)).toBe(false);
  const disc = spawn(world, { position: { y: 0.5 }, collider: { radius: 0.5, density: 1 } });
  run(world, 1);
  expect(world.components.Position.y[disc]).toBeCloseTo(0.5, 2);
});

test('a snapshot brings a heap of compounds back to the bit', () => {
  const world = rigidWorld({ precision: 'f32' });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.5 } });
  const roof = polygon([{ x: -0.6 }, { x: 0.6 }, { y: 0.5 }]);
  for (let i = 0; i < 12; i++) {
    const parts = [
      { shape: box(1, 0.3), density: 1, friction: 0.5 },
      { shape: roof, ...roof.centre, y: 0.4, density: 1, friction: 0.5 },
    ];
    spawnCompound(world, { position: { x: 0.1 * (i % 3), y: 1 + i }, rotation: i, parts });
  }
  run(world, 1.5);
  const kept = snapshot(world);
  run(world, 2);
  const hash = stateHash(world);
  restore(world, kept);
  run(world, 2);
  expect(stateHash(world)).toBe(hash);
});

test('what cannot be a compound is refused, and nothing is made', () => {
  const world = rigidWorld();
  const part = { radius: 0.5, density: 1 };
  const make =
    (parts: unknown, more: object = {}) =>
    () =>
      spawnCompound(world, { parts, ...more } as never);
  expect(make(undefined)).toThrow(refused('E_TYPE'));
  expect(make([])).toThrow(refused('E_RANGE'));
  expect(make([undefined])).toThrow(refused('E_TYPE'));
  expect(make([part, { ...part, x: Number.NaN }])).toThrow(refused('E_NONFINITE'));
  expect(make([{ ...part, density: -1 }])).toThrow(refused('E_RANGE'));
  expect(make([{ ...part, shape: box(1, 1) }])).toThrow(refused('E_RANGE'));
  expect(make([{ shape: segment({}, { x: 1 }), density: 1 }])).toThrow(refused('E_RANGE'));
  expect(make([part, { ...part, frction: 1 }])).toThrow(refused('E_UNKNOWN'));
  expect(make([part], { rotation: '1' })).toThrow(refused('E_TYPE'));
  expect(make([part], { position: { x: '1' } })).toThrow(refused('E_TYPE'));
  expect(make([part], { mass: -1 })).toThrow(refused('E_RANGE'));
  expect(make([{ parts: [part] }])).toThrow();
  expect(() => spawnCompound(world, undefined as never)).toThrow(refused('E_TYPE'));
  expect(world.internal.counts.Position).toBe(0);
  const space = createPhysicsWorld({ dimensions: 3 });
  expect(() => spawnCompound(space, { parts: [part] })).toThrow(refused('E_RANGE'));
});

test('a part of a part, an incomplete part and a joint to a part are refused by the step, with the way out', () => {
  const world = rigidWorld();
  const { body, parts } = spawnCompound(world, { parts: [{ radius: 0.5, density: 1 }] });
  const stray = { position: {}, rotation: 0, collider: 0.5 } as const;
  const [upper, lower] = [spawn(world, stray), spawn(world, stray)];
  // Neither body is a part when another is attached to it, but in the end one is.
  addComponent(world, upper, set(world.components.Attachment, { body: lower }));
  addComponent(world, lower, set(world.components.Attachment, { body }));
  expect(() => step(world, DT)).toThrow(/part itself/);
  for (const id of [upper, lower]) despawn(world, id);
  const blank = spawn(world, { position: {}, attachment: { body } });
  expect(() => step(world, DT)).toThrow(/has no Rotation/);
  despawn(world, blank);
  const post = spawn(world, { position: { y: 3 } });
  const joint = createJoint(world, revolute({ a: post, b: parts[0], anchor: { y: 3 } }));
  // createJoint takes the body instead.
  world.components.Joint.b[joint] = parts[0];
  expect(() => step(world, DT)).toThrow(/joins 2, which is a part/);
  despawn(world, joint);
  step(world, DT);
  expect(() => spawn(world, { attachment: { body: 99 } })).toThrow(refused('E_STALE'));
});

test('no part is accepted where a component needs a body, and its parts know a body with an id that was used before', () => {
  const world = rigidWorld();
  despawn(world, spawn(world, { position: {} }));
  const { body, parts } = spawnCompound(world, { parts: [-1, 1].map((x) => ({ x, radius: 0.5, density: 1 })) });
  const { Attachment, Joint } = world.components;
  const collider = { position: {}, rotation: {}, collider: { radius: 0.5 } };
  spawnMany(world, 2, { ...collider, attachment: { body } });
  step(world, DT);
  expect(partsOf(world, body)).toHaveLength(4);
  const joint = createJoint(world, revolute({ b: body, anchor: {} }));
  const attempts = [
    () => addComponent(world, parts[1], set(Attachment, { body: parts[0] })),
    () => addComponent(world, parts[1], set(Attachment, { body: parts[1] })),
    () => spawn(world, { position: {}, rotation: 0, collider: 0.5, attachment: { body: parts[0] } }),
    () => spawn(world, { position: {}, rotation: 0, collider: 0.5, attachment: {} }),
    () => spawnMany(world, 2, { ...collider, attachment: { body: [body, parts[0]] } }),
    () => addComponent(world, joint, set(Joint, { b: parts[0] })),
  ];
  for (const attempt of attempts) expect(attempt).toThrow(refused('E_RANGE'));
  expect([Attachment.body[parts[1]], Joint.b[joint]]).toEqual([body, body]);
  step(world, DT);
  expect(partsOf(world, body)).toHaveLength(4);
});
