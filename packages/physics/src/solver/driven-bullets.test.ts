// Bullets that touch each other are driven on by what moves as other bodies are, and among themselves lose no momentum.
import {
  box,
  centreOfMass,
  circle,
  createPhysicsWorld,
  createRandom,
  momentum,
  rigidBodies,
  spawn,
  spawnCompound,
  step,
  totalMass,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';

const DT = 1 / 60;
const RADIUS = 0.08;
const BALL = { shape: circle(RADIUS), density: 1000, friction: 0.4 } as const;

const worldOf = (precision: 'f32' | 'f64') =>
  createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], precision, capacity: 200 });

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    [10, 0.2],
    [20, 0.2],
    [30, 0.2],
    [10, 1],
  ])('a wall of %d m/s, %d m thick, sweeps up a heap of bullets', (speed, thickness) => {
    const world = worldOf(precision);
    const { x } = world.components.Position;
    spawn(world, { position: { x: 500, y: -0.5 }, collider: { shape: box(1100, 1), friction: 0.5 } });
    const balls = Array.from({ length: 120 }, (_, i) => {
      const position = { x: 1 + (i >> 2) * 0.2, y: RADIUS + (i & 3) * 0.168 };
      return spawn(world, { position, collider: { ...BALL, bullet: true } });
    });
    const velocity = { x: speed };
    const collider = { shape: box(thickness, 20), friction: 0.5 };
    const wall = spawn(world, { position: { x: -1 - thickness / 2, y: 10 }, velocity, collider });
    for (let i = 0; i < 180; i++) {
      step(world, DT);
      // No centre comes into the wall.
      expect(Math.min(...balls.map((ball) => x[ball])) - x[wall]).toBeGreaterThan(thickness / 2);
    }
  });

  it('a box that is shaken and one that is thrown keep what is in them', () => {
    const world = worldOf(precision);
    const { Position, Velocity, Rotation } = world.components;
    const side = { friction: 0.4, density: 500 };
    const parts = [
      { ...side, shape: box(2, 0.2), y: -1 },
      { ...side, shape: box(2, 0.2), y: 1 },
      { ...side, shape: box(0.2, 2), x: -1 },
      { ...side, shape: box(0.2, 2), x: 1 },
    ];
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(1000, 1), friction: 0.5 } });
    const boxes = [
      spawnCompound(world, { position: { x: -60, y: 3 }, velocity: {}, kinematic: {}, parts }).body,
      spawnCompound(world, { position: { y: 3 }, velocity: { x: 20, y: 10 }, angularVelocity: -10, parts }).body,
    ];
    const balls = boxes.map((body, k) =>
      Array.from({ length: 49 }, (_, i) => {
        const x = 0.2 * (i % 7) - 0.6;
        const y = 0.2 * Math.floor(i / 7) - 0.6;
        const velocity = k === 0 ? {} : { x: 20 + 10 * y, y: 10 - 10 * x };
        const position = { x: Position.x[body] + x, y: 3 + y };
        return spawn(world, { position, velocity, collider: { ...BALL, bullet: true } });
      }),
    );
    for (let i = 0; i < 400; i++) {
      Velocity.x[boxes[0]] = 19 * Math.cos((6 * Math.PI * i) / 60);
      step(world, DT);
    }
    for (const [k, body] of boxes.entries()) {
      const cosine = Math.cos(Rotation.angle[body]);
      const sine = Math.sin(Rotation.angle[body]);
      for (const ball of balls[k]) {
        const x = Position.x[ball] - Position.x[body];
        const y = Position.y[ball] - Position.y[body];
        expect(Math.max(Math.abs(cosine * x + sine * y), Math.abs(cosine * y - sine * x))).toBeLessThan(1);
      }
    }
  });
});

test('the centre of mass of bullets that collide moves on as it did', () => {
  for (const speed of [2, 10, 30]) {
    const world = createPhysicsWorld({ preset: rigidBodies, forces: [], capacity: 100 });
    const random = createRandom(3);
    for (let i = 0; i < 49; i++) {
      const x = 0.17 * (i % 7) - 0.5;
      const y = 0.17 * Math.floor(i / 7) - 0.5;
      const velocity = { x: random.uniform(-1, 1) - speed * x, y: -speed * y };
      spawn(world, { position: { x, y }, velocity, collider: { ...BALL, friction: 0, bullet: true } });
    }
    const start = centreOfMass(world).x;
    const drift = momentum(world).x / totalMass(world);
    for (let i = 0; i < 120; i++) step(world, DT);
    // Rounding of f64 in 120 steps.
    expect(Math.abs(centreOfMass(world).x - start - drift * 2)).toBeLessThan(1e-13);
  }
});
