// Bodies that slide and roll over curved surfaces: the normal turns as they go, and no energy may come of it.
import {
  attractors,
  box,
  type PhysicsWorld,
  type Precision,
  softStep,
  spawn,
  spawnChain,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const G = 9.81;

/** A half circle that is open above, of chords that are far shorter than the body. */
function addBowl(world: PhysicsWorld, radius: number, friction: number): void {
  const points = Array.from({ length: 401 }, (_, i) => {
    const angle = (-Math.PI * i) / 400;
    return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
  });
  spawnChain(world, points, { friction });
}

/** The largest angle from the lowest point in each of some times of equal length. */
function swings(world: PhysicsWorld, body: number, times: number, length: number, dt = DT): number[] {
  const { x, y } = world.components.Position;
  return Array.from({ length: times }, () => {
    let most = 0;
    for (let i = 0; i * dt < length; i++) {
      step(world, dt);
      most = Math.max(most, Math.abs(Math.atan2(x[body], -y[body])));
    }
    return most;
  });
}

describe.each([
  ['slides', 0],
  ['rolls', 1],
])('a ball that %s in a bowl', (_, friction) => {
  test.each([1, 2, 5])('of radius %s m rises no higher, minute after minute', (radius) => {
    const world = rigidWorld();
    addBowl(world, radius, friction);
    const ball = 0.2 * radius;
    const way = radius - ball;
    const position = { x: way * Math.sin(0.3), y: -way * Math.cos(0.3) };
    const body = spawn(world, { position, collider: { radius: ball, density: 100, friction } });
    const heights = swings(world, body, 4, 15);
    // In the first swing it may come down and settle by the slop.
    for (const angle of heights) expect(angle).toBeLessThan(0.302);
    // What is lost: an inelastic polygon of one side a step, v²dt/2R² of the speed in a second, and the chords as much again.
    const speed = 0.3 * Math.sqrt(G * way);
    const loss = ((speed * speed) / 2) * (DT / (2 * way * way) + Math.PI / 400 / way / 2) * 60;
    expect(heights[3]).toBeGreaterThan(0.3 * Math.exp(-4 * loss) - 0.15);
  });
});

// With points that were kept while it slid on by up to 5 cm its corners sank in by 4 mm wherever they came to the next segment; what
// pressed them out again raised the box, at any length of a step: from 0.3 to 0.49 rad in 40 s.
describe.each([1, 2])('a smooth box in a bowl of radius %s m', (radius) => {
  const half = 0.1;
  const swingsOf = (dt: number) => {
    const world = rigidWorld();
    addBowl(world, radius, 0);
    const way = Math.sqrt(radius * radius - half * half) - half;
    const position = { x: way * Math.sin(0.3), y: -way * Math.cos(0.3) };
    const collider = { shape: box(2 * half, 2 * half), density: 25, friction: 0 };
    return swings(world, spawn(world, { position, rotation: 0.3, collider }), 4, 10, dt);
  };

  test.each([60, 240])('rises no higher, swing after swing, at %d Hz', (rate) => {
    const heights = swingsOf(1 / rate);
    for (const angle of heights) expect(angle).toBeLessThan(0.302);
    // Two corners lose what a ball does, each: that of an inelastic polygon of one side a step, and the chords as much again.
    const way = radius - half;
    const speed = 0.3 * Math.sqrt(G * way);
    const loss = speed * speed * (1 / rate / (2 * way * way) + Math.PI / 400 / way / 2) * 40;
    expect(heights[3]).toBeGreaterThan(0.3 * Math.exp(-loss) - 0.15);
  });
});

test('a ball that slides round a fixed ball keeps its speed to half a per cent a second', () => {
  const world = rigidWorld({ forces: [attractors()] });
  const [R, r] = [5, 0.3];
  const g = 8.7;
  spawn(world, { position: {}, attractor: g * (R + r) * (R + r) });
  spawn(world, { position: {}, collider: { radius: R, friction: 0 } });
  const collider = { radius: r, density: 1, friction: 0 };
  const body = spawn(world, { position: { y: R + r }, velocity: { x: 1 }, collider });
  run(world, 10);
  const speed = Math.hypot(world.components.Velocity.x[body], world.components.Velocity.y[body]);
  // What is left is the error of a sub-step, g h/2R; the normal of the start of the step lost g dt/2R of the speed in a second.
  expect(speed).toBeGreaterThan(1 - 0.005);
  expect(speed).toBeLessThan(Math.exp((g * (DT / 4) * 10) / (2 * (R + r))) + 0.005);
});

const BOUNCES: readonly (readonly [Precision, number, number])[] = [
  ['f64', 5, 60],
  ['f64', 60, 60],
  ['f64', 20, 30],
  ['f32', 60, 60],
];

test.each(BOUNCES)(
  'balls that bounce about in a ring of segments gain no energy, in %s at %d m/s and %d Hz',
  (precision, v, rate) => {
    const world = rigidWorld({ forces: [], precision, integrator: softStep({ restitutionThreshold: 0.01 }) });
    const ring = Array.from({ length: 128 }, (_, i) => {
      const angle = (-i / 128) * 2 * Math.PI;
      return { x: 3 * Math.cos(angle), y: 3 * Math.sin(angle) };
    });
    spawnChain(world, ring, { restitution: 1, friction: 0 }, { closed: true });
    const collider = { radius: 0.1, density: 1, restitution: 1, group: -1 };
    const balls = Array.from({ length: 60 }, (_, k) => {
      const position = { x: 0.4 * (k % 8) - 1.4, y: 0.4 * Math.floor(k / 8) - 1.4 };
      return spawn(world, { position, velocity: { x: v * Math.cos(k), y: v * Math.sin(k) }, collider });
    });
    const { x, y } = world.components.Velocity;
    for (let i = 0; i < 20 * rate; i++) step(world, 1 / rate);
    // Some may meet two segments at once, whose normals differ by 2.8 degrees. Rounding of f32 adds up over 200 bounces.
    const rounding = 200 * 2 ** (precision === 'f32' ? -22 : -51);
    for (const ball of balls) expect((x[ball] ** 2 + y[ball] ** 2) / v ** 2).toBeLessThan(1 + rounding);
  },
);
