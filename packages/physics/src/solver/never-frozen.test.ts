// What has a velocity moves: the sweep of fast bodies halts none in the same place again and again. Random levels of all that forces do
// not move, and bodies at up to 140 m/s, many of which begin inside of something.
import {
  type BodyInput,
  box,
  capsule,
  circle,
  createRandom,
  type PhysicsWorld,
  polygon,
  type Random,
  type Shape,
  segment,
  spawn,
  spawnChain,
  step,
} from '@principia/physics';
import { expect, test } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const WORLDS = 150;
const STEPS = 90;
/** What presses on another body may wait for a few steps until that gives way. */
const PATIENCE = 15;

const between = (random: Random, low: number, high: number) => low + (high - low) * random.uniform();

function anyShape(random: Random): Shape {
  const r = between(random, 0.05, 0.5);
  const shapes = [
    circle(r),
    box(2 * r, between(random, 0.1, 1)),
    capsule(between(random, 0.1, 1), 0.4 * r),
    box(r, r, { rounding: 0.2 * r }),
    polygon([
      { x: -r, y: -r },
      { x: r, y: -0.8 * r },
      { x: 0.1 * r, y: 1.3 * r },
    ]),
  ];
  return shapes[Math.floor(random.uniform() * shapes.length)];
}

function addChain(world: PhysicsWorld, random: Random, x: number, y: number): void {
  const points = [{ x, y }];
  let angle = between(random, 0, 2 * Math.PI);
  for (let i = 0; i < 5; i++) {
    angle += between(random, -1, 1);
    const length = between(random, 0.3, 2);
    const { x, y } = points[i];
    points.push({ x: x + length * Math.cos(angle), y: y + length * Math.sin(angle) });
  }
  spawnChain(world, points, { friction: random.uniform(), restitution: random.uniform() });
}

function addObstacle(world: PhysicsWorld, random: Random): void {
  const x = between(random, -3, 3);
  const y = between(random, -3, 3);
  const kind = Math.floor(random.uniform() * 8);
  if (kind < 3) {
    addChain(world, random, x, y);
    return;
  }
  const u = (low: number, high: number) => between(random, low, high);
  const place = { position: { x, y }, rotation: { angle: u(0, 6) } };
  const obstacles: BodyInput[] = [
    { ...place, collider: { shape: box(u(0.1, 3), u(0.05, 1)), restitution: u(0, 1) } },
    { ...place, collider: { shape: segment({ x: -1 }, { x: 1 }) } },
    { ...place, collider: { shape: box(u(0.5, 3), u(0.1, 0.3)), oneWay: 1 } },
    { ...place, collider: { radius: u(0.1, 1) } },
    { segmentWall: { ax: x, ay: y, bx: x + u(-3, 3), by: y + u(-3, 3) } },
  ];
  spawn(world, obstacles[kind - 3]);
}

function addBody(world: PhysicsWorld, random: Random): number {
  const u = (low: number, high: number) => between(random, low, high);
  const speed = 10 ** u(0, 2);
  return spawn(world, {
    position: { x: u(-4, 4), y: u(-4, 4) },
    rotation: { angle: u(0, 6) },
    velocity: { x: u(-1, 1) * speed, y: u(-1, 1) * speed },
    angularVelocity: { z: u(-20, 20) },
    collider: {
      shape: anyShape(random),
      density: u(0.5, 5),
      friction: u(0, 1),
      restitution: u(0, 1),
      bullet: u(0, 1) < 0.2,
    },
  });
}

/** The longest time for which a body stayed where it was with a velocity, in steps. */
function longestHalt(world: PhysicsWorld, ids: readonly number[]): number {
  const { Position, Velocity } = world.components;
  const halts = ids.map(() => 0);
  let longest = 0;
  for (let i = 0; i < STEPS; i++) {
    const before = ids.map((id) => [Position.x[id], Position.y[id]]);
    step(world, DT);
    ids.forEach((id, k) => {
      const isHalted = Position.x[id] === before[k][0] && Position.y[id] === before[k][1];
      halts[k] = isHalted && Math.hypot(Velocity.x[id], Velocity.y[id]) > 1 ? halts[k] + 1 : 0;
      longest = Math.max(longest, halts[k]);
    });
  }
  return longest;
}

test.each(['f32', 'f64'] as const)('bodies with a velocity move, in levels of any kind: %s', (precision) => {
  for (let seed = 0; seed < WORLDS; seed++) {
    const random = createRandom(seed, precision === 'f32' ? 0 : 1);
    const world = rigidWorld({ precision, ...(seed % 3 === 0 ? { forces: [] } : {}) });
    for (let i = 0; i < 4; i++) addObstacle(world, random);
    const ids = Array.from({ length: 6 }, () => addBody(world, random));
    expect(longestHalt(world, ids), `level ${seed}`).toBeLessThan(PATIENCE);
  }
});

test('crates that begin inside of a disc come out', () => {
  for (let k = 0; k < 24; k++) {
    const world = rigidWorld({ precision: 'f64', forces: [] });
    spawn(world, { position: {}, collider: { radius: 0.9 } });
    const b = spawn(world, {
      position: { y: 0.54 },
      rotation: { angle: 0.27 * k },
      velocity: { y: -3 - (k % 5) },
      angularVelocity: { z: (k % 3) * 7 - 7 },
      collider: { shape: box(0.854, 0.208), density: 1 },
    });
    for (let i = 0; i < 240; i++) step(world, DT / 2);
    const { x, y } = world.components.Position;
    expect(Math.hypot(x[b], y[b]), `crate ${k}`).toBeGreaterThan(0.9);
  }
});
