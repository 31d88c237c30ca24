import { describe, expect, test } from 'vitest';
import {
  createPhysicsWorld,
  createRandom,
  discInertia,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '../index.ts';

const make = (options: PhysicsWorldOptions = {}) =>
  createPhysicsWorld({ preset: particleContacts, capacity: 1000, ...options });

type Ends = readonly [ax: number, ay: number, bx: number, by: number];

function wall(world: PhysicsWorld, [ax, ay, bx, by]: Ends, parts: { restitution?: number; friction?: number } = {}) {
  return spawn(world, { segmentWall: { ax, ay, bx, by, ...parts } });
}

function disc(world: PhysicsWorld, x: number, y: number, vx: number, vy: number, radius: number, restitution = 0) {
  return spawn(world, { position: { x, y }, velocity: { x: vx, y: vy }, mass: 1, collider: { radius, restitution } });
}

const BOX: readonly Ends[] = [
  [50, 50, 550, 50],
  [550, 50, 550, 400],
  [550, 400, 50, 400],
  [50, 400, 50, 50],
];
const INNER: readonly Ends[] = [
  [100, 100, 200, 120],
  [350, 170, 450, 140],
  [130, 200, 260, 300],
  [370, 310, 470, 280],
];

describe.each(['f32', 'f64'] as const)('a ball that falls on an inclined wall, %s', (precision) => {
  test('hits and leaves it as the formulas predict', () => {
    const world = make({ precision, forces: [uniformGravity({ y: 100 })] });
    wall(world, [50, 200, 700, 500]);
    const ball = disc(world, 100, 50, 0, 0, 15, 0.8);
    const { x, y } = world.components.Velocity;
    while (x[ball] === 0) step(world, 1 / 60);
    // The velocity at the contact, 1.76950 s after the start, plus the effect of gravity since.
    const since = world.time - 1.7695;
    expect(since).toBeGreaterThan(0);
    expect(since).toBeLessThan(1 / 60);
    expect(x[ball] / 121.189).toBeCloseTo(1, 3);
    expect((y[ball] - 100 * since) / -85.626).toBeCloseTo(1, 3);
  });
});

describe('sides and ends', () => {
  test.each([1, -1])('both sides are solid: from side %d', (side) => {
    const world = make();
    wall(world, [-5, 0, 5, 0]);
    const ball = disc(world, 0, 3 * side, 2, -4 * side, 0.5, 1);
    for (let i = 0; i < 60; i++) step(world, 1 / 60);
    const [p, v] = [world.components.Position, world.components.Velocity];
    expect(v.x[ball]).toBeCloseTo(2, 12);
    expect(v.y[ball]).toBeCloseTo(4 * side, 12);
    // The ball covers 2.5 m to the contact at 0.625 s.
    expect(p.y[ball]).toBeCloseTo((0.5 + 4 * 0.375) * side, 10);
  });

  test('an end deflects a ball along the line from the end to its centre', () => {
    const world = make();
    wall(world, [0, -9, 0, 0]);
    const ball = disc(world, 0.6, 3, 0, -5, 1, 1);
    for (let i = 0; i < 60; i++) step(world, 1 / 60);
    const { x, y } = world.components.Velocity;
    // The centre is at (0.6, 0.8) at the contact: n = (0.6, 0.8), v - 2 (v·n) n.
    expect(x[ball]).toBeCloseTo(4.8, 10);
    expect(y[ball]).toBeCloseTo(1.4, 10);
  });

  test('a wall of zero length is a post', () => {
    const world = make();
    wall(world, [0, 0, 0, 0]);
    const ball = disc(world, 0, 3, 0, -5, 1, 1);
    for (let i = 0; i < 60; i++) step(world, 1 / 60);
    expect(world.components.Velocity.y[ball]).toBeCloseTo(5, 10);
  });

  test('restitution is the larger of the two', () => {
    for (const [body, ofWall] of [
      [0.2, 0.7],
      [0.7, 0.2],
    ]) {
      const world = make();
      wall(world, [-5, 0, 5, 0], { restitution: ofWall });
      const ball = disc(world, 0, 1, 0, -10, 0.5, body);
      for (let i = 0; i < 10; i++) step(world, 0.01);
      expect(world.components.Velocity.y[ball]).toBeCloseTo(7, 10);
    }
  });
});

describe('no tunnelling', () => {
  test.each(['f32', 'f64'] as const)('a thousand balls of 1 at 10⁴ a second, %s', (precision) => {
    const world = make({ precision, capacity: 1100 });
    // A wall from top to bottom divides the box: no ball may change sides.
    const PARTITION = [300, 50, 320, 400] as const;
    for (const ends of [...BOX, ...INNER, PARTITION]) wall(world, ends, { restitution: 1 });
    const random = createRandom(7);
    const balls = Array.from({ length: 1000 }, (_, i) => {
      const { x: c, y: s } = random.onCircle();
      const x = i < 500 ? random.uniform(60, 90) : random.uniform(500, 540);
      return disc(world, x, random.uniform(60, 390), 1e4 * c, 1e4 * s, 1, 1);
    });
    world.phases.collide.length = 0;
    const { Position: p, Velocity: v } = world.components;
    const root = Math.hypot(20, 350);
    for (let i = 0; i < 60; i++) {
      step(world, 1 / 60);
      const strays = balls.filter((ball, k) => {
        const [x, y] = [p.x[ball], p.y[ball]];
        const beyond = ((x - 300) * 350 - (y - 50) * 20) / root;
        // Each ball is a radius from every wall, to a few rounding errors of 550 in f32, 3e-5 each.
        return !(x > 50.999 && x < 549.001 && y > 50.999 && y < 399.001 && (k < 500 ? -beyond : beyond) > 0.999);
      });
      expect(strays).toEqual([]);
    }
    // The balls keep their speed to rounding: at most 1000 bounces over a path of 10⁴ m, each with a few rounding
    // errors.
    const rounding = 1000 * 4 * (precision === 'f32' ? 2 ** -24 : 2 ** -53);
    for (const ball of balls) expect(Math.abs(Math.hypot(v.x[ball], v.y[ball]) / 1e4 - 1)).toBeLessThan(rounding);
  });

  test('the energy of a ball among many walls is constant for a minute', () => {
    const world = make({ forces: [uniformGravity({ y: 100 })] });
    for (const ends of [...BOX, ...INNER]) wall(world, ends, { restitution: 1 });
    const ball = disc(world, 200, 90, 0, 0, 12, 1);
    const [p, v] = [world.components.Position, world.components.Velocity];
    const energyNow = () => 0.5 * (v.x[ball] ** 2 + v.y[ball] ** 2) - 100 * p.y[ball];
    const start = energyNow();
    let worst = 0;
    for (let i = 0; i < 3600; i++) {
      step(world, 1 / 60);
      worst = Math.max(worst, Math.abs(energyNow() - start));
      expect(p.x[ball] > 61.99 && p.x[ball] < 538.01 && p.y[ball] > 61.99 && p.y[ball] < 388.01).toBe(true);
    }
    // The scale is g times the height of the box.
    expect(worst / (100 * 310)).toBeLessThan(1e-6);
  });

  test('a pile does not push bodies through the shelf below it', () => {
    const world = make({ forces: [uniformGravity({ y: -10 })] });
    for (const ends of [
      [-2, 0, 2, 0],
      [-2, 0, -2, 30],
      [2, 0, 2, 30],
    ] as const) {
      wall(world, ends);
    }
    const balls = Array.from({ length: 120 }, (_, i) =>
      disc(world, -1.5 + (i % 8) * 0.43, 0.3 + 0.45 * Math.floor(i / 8), 0, 0, 0.2),
    );
    for (let i = 0; i < 600; i++) step(world, 1 / 60);
    const { x, y } = world.components.Position;
    for (const ball of balls) expect(y[ball] > 0.1 && Math.abs(x[ball]) < 1.9).toBe(true);
  });
});

test('a disc that does not slip rolls down at two thirds of g sin θ', () => {
  const world = make({ forces: [uniformGravity({ y: -10 })] });
  // The slope is a 3-4-5 triangle: sin θ = 0.6.
  wall(world, [0, 0, -40, 30]);
  const ball = spawn(world, {
    position: { x: -32 + 0.6 * 0.5, y: 24 + 0.8 * 0.5 },
    velocity: {},
    mass: 2,
    inertia: discInertia(2, 0.5),
    angularVelocity: {},
    collider: { radius: 0.5, friction: 1 },
  });
  for (let i = 0; i < 120; i++) step(world, 1 / 60);
  const [v, w] = [world.components.Velocity, world.components.AngularVelocity];
  const speed = Math.hypot(v.x[ball], v.y[ball]);
  expect(speed).toBeCloseTo((2 / 3) * 10 * 0.6 * 2, 9);
  expect(-w.z[ball] * 0.5).toBeCloseTo(speed, 9);
  const { x, y } = world.components.Position;
  expect(0.6 * x[ball] + 0.8 * y[ball]).toBeCloseTo(0.5, 9);
});

test('a ball in a groove of two walls stays at rest', () => {
  for (const half of [1, 3, 0.4]) {
    const world = make({ forces: [uniformGravity({ y: -10 })] });
    wall(world, [0, 0, half, 1]);
    wall(world, [0, 0, -half, 1]);
    const ball = disc(world, 0.02, (0.2 * Math.sqrt(1 + half * half)) / half + 0.3, 0, 0, 0.2, 0.3);
    for (let i = 0; i < 900; i++) step(world, 1 / 60);
    const [p, v] = [world.components.Position, world.components.Velocity];
    // The position where it touches both walls is accurate to the motion of one step up and one down, g dt² each; the
    // speed is at most that of one step of gravity.
    for (let i = 0; i < 60; i++) {
      step(world, 1 / 60);
      expect(Math.hypot(p.x[ball], p.y[ball] - (0.2 * Math.sqrt(1 + half * half)) / half)).toBeLessThan(
        (2 * 10) / 60 ** 2,
      );
      expect(Math.hypot(v.x[ball], v.y[ball])).toBeLessThan(10 / 60);
    }
  }
});

test('distant walls, which enable the grid, change nothing', () => {
  const build = (extra: number) => {
    const world = make();
    const ball = disc(world, 100, 90, 300, 170, 4, 1);
    for (const ends of [...BOX, ...INNER]) wall(world, ends);
    const random = createRandom(3);
    for (let i = 0; i < extra; i++) {
      const [x, y] = [random.uniform(1000, 5000), random.uniform(-3000, 3000)];
      wall(world, [x, y, x + random.uniform(-99, 99), y + random.uniform(-99, 99)]);
    }
    for (let i = 0; i < 600; i++) step(world, 1 / 60);
    const { x, y } = world.components.Position;
    return [x[ball], y[ball]];
  };
  expect(build(500)).toEqual(build(0));
});

test('walls created, moved or removed between steps take effect immediately', () => {
  const world = make();
  const ball = disc(world, 0, 2, 0, -10, 0.5, 1);
  const floor = wall(world, [-5, 0, 5, 0]);
  world.components.SegmentWall.ay[floor] = -9;
  world.components.SegmentWall.by[floor] = -9;
  for (let i = 0; i < 60; i++) step(world, 0.01);
  expect(world.components.Velocity.y[ball]).toBe(-10);
  for (let i = 0; i < 60; i++) step(world, 0.01);
  expect(world.components.Velocity.y[ball]).toBeCloseTo(10, 12);
});

test('equal runs are bitwise equal', () => {
  const run = () => {
    const world = make({ precision: 'f32', forces: [uniformGravity({ y: 100 })] });
    for (const ends of [...BOX, ...INNER]) wall(world, ends, { friction: 0.5 });
    const random = createRandom(5);
    for (let i = 0; i < 50; i++) {
      disc(world, random.uniform(80, 500), random.uniform(70, 380), random.uniform(-99, 99), 0, 5, 0.6);
    }
    for (let i = 0; i < 200; i++) step(world, 1 / 60);
    return stateHash(world);
  };
  expect(run()).toBe(run());
});
