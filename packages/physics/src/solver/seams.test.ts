// Bodies that move over floors of separate tiles do not feel the seams between them, and feel everything else.
import {
  type BodyInput,
  box,
  capsule,
  circle,
  type PhysicsWorld,
  spawn,
  spawnCompound,
  step,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** Tiles of 1 m by 1 m beside each other, whose tops are at height 0. */
function layTiles(world: PhysicsWorld, count: number, friction: number, width = 1): void {
  for (let i = 0; i < count; i++) {
    spawn(world, { position: { x: (i + 0.5) * width, y: -0.5 }, collider: { shape: box(width, 1), friction } });
  }
}

/** Steps until the body is at the end of the floor; returns how far it was above and below its height in between. */
function cross(world: PhysicsWorld, body: number, height: number, end: number) {
  const { Position, Velocity } = world.components;
  let above = 0;
  let below = 0;
  let steps = 0;
  for (; Position.x[body] < end && steps < 20000; steps++) {
    step(world, DT);
    above = Math.max(above, Position.y[body] - height);
    below = Math.max(below, height - Position.y[body]);
  }
  expect(Position.x[body]).toBeGreaterThanOrEqual(end);
  return { above, below, speed: Velocity.x[body] };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    ['a ball', { radius: 0.5 }, 0.5, 5],
    ['a small ball', { radius: 0.1 }, 0.1, 5],
    ['a fast ball', { radius: 0.5 }, 0.5, 30],
  ] as const)('%s rolls over 1 000 tiles as over one', (_, shape, height, speed) => {
    const world = rigidWorld({ precision, capacity: 1100 });
    layTiles(world, 1000, 0.6);
    const body = spawn(world, {
      position: { x: 1.3, y: height },
      velocity: { x: speed },
      angularVelocity: { z: -speed / height },
      collider: { ...shape, density: 1, friction: 0.6 },
    });
    const { above, below, speed: end } = cross(world, body, height, 990);
    expect(above).toBeLessThan(0.1 * SLOP);
    expect(below).toBeLessThan(SLOP);
    expect(end).toBeCloseTo(speed, 2);
  });

  it.each<[string, BodyInput['collider'], number]>([
    ['a box', { shape: box(1, 1) }, 0.5],
    ['a plate', { shape: box(2, 0.5) }, 0.25],
    ['a rounded box', { shape: box(1, 1, { rounding: 0.1 }) }, 0.5],
    ['a capsule', { shape: capsule(0.6, 0.2) }, 0.2],
    ['a disc', { radius: 0.3 }, 0.3],
  ])('%s without friction slides over 200 tiles and keeps its speed', (_, collider, height) => {
    for (const width of [1, 0.2]) {
      const world = rigidWorld({ precision, capacity: 300 });
      layTiles(world, 200, 0, width);
      const made = { ...(collider as object), density: 1, friction: 0 };
      const body = spawn(world, { position: { x: 1.3, y: height }, velocity: { x: 5 }, collider: made });
      const { above, below, speed } = cross(world, body, height, 198 * width);
      expect(above).toBeLessThan(SLOP);
      expect(below).toBeLessThan(SLOP);
      expect(Math.abs(speed - 5)).toBeLessThan(0.05);
    }
  });
});

test.each<[string, number, BodyInput['collider'], number]>([
  ['a small box', 20, { shape: box(0.5, 0.5) }, 0.25],
  ['a box', 40, { shape: box(1, 1) }, 0.5],
  ['a plate', 10, { shape: box(2, 0.2) }, 0.1],
  ['a capsule', 20, { shape: capsule(0.6, 0.2) }, 0.2],
])('%s of %s m/s, which moves by its height or so in a step, halts at no seam', (_, speed, collider, height) => {
  for (const precision of ['f32', 'f64'] as const) {
    const world = rigidWorld({ precision, capacity: 300 });
    layTiles(world, 200, 0);
    const made = { ...(collider as object), density: 1, friction: 0 };
    const body = spawn(world, { position: { x: 3, y: height }, velocity: { x: speed }, collider: made });
    const steps = Math.floor(190 / speed / DT);
    for (let i = 0; i < steps; i++) step(world, DT);
    // It would be put back by a part of a step at each of 190 seams.
    const behind = 3 + steps * DT * speed - (world.components.Position.x[body] as number);
    expect(Math.abs(behind)).toBeLessThan(speed * DT);
  }
});

describe.each(['f32', 'f64'] as const)('in %s, over 200 tiles that move', (precision) => {
  it.each<[string, { x: number; y: number }, BodyInput['collider'], number]>([
    ['a ball against a belt', { x: -2, y: 0 }, { radius: 0.5 }, 0.5],
    ['a ball on a lift', { x: 0, y: 0.5 }, { radius: 0.5 }, 0.5],
    ['a box on a slanting lift', { x: -3, y: 0.2 }, { shape: box(1, 1) }, 0.5],
  ])('%s glides as over one', (_, velocity, shape, height) => {
    const world = rigidWorld({ precision });
    const tile = { velocity, kinematic: {}, collider: { shape: box(1, 1), friction: 0, density: 1 } };
    const tiles = Array.from({ length: 200 }, (__, i) => spawn(world, { ...tile, position: { x: i + 0.5, y: -0.5 } }));
    const collider = { ...(shape as object), density: 1, friction: 0 };
    const body = spawn(world, { position: { x: 100, y: height }, velocity: { x: 4, y: velocity.y }, collider });
    const { Position, Velocity } = world.components;
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      const above = (Position.y[body] as number) - (Position.y[tiles[0] as number] as number) - 0.5 - height;
      expect(above).toBeLessThan(0.1 * SLOP);
      expect(above).toBeGreaterThan(-SLOP);
    }
    // Nothing but the seams could slow it.
    expect(Velocity.x[body]).toBeCloseTo(4, 2);
  });
});

test('a disc that slides at first rolls with two thirds of its speed in the end, as on one plate', () => {
  const world = rigidWorld({ capacity: 300 });
  layTiles(world, 200, 0.6);
  const collider = { radius: 0.5, density: 1, friction: 0.6 };
  const body = spawn(world, { position: { x: 1.3, y: 0.5 }, velocity: { x: 5 }, collider });
  // v₀ − v = r ω / 2 and v = r ω: a disc of moment of inertia m r²/2.
  expect(cross(world, body, 0.5, 150).speed).toBeCloseTo((2 / 3) * 5, 2);
});

test('a ball that falls beside a seam bounces straight up', () => {
  for (const x of [3, 3.02, 2.9, 3.1]) {
    const world = rigidWorld({ capacity: 50 });
    layTiles(world, 6, 0.6);
    const ball = spawn(world, { position: { x, y: 2 }, collider: { radius: 0.5, density: 1, restitution: 0.8 } });
    run(world, 1);
    expect(world.components.Position.x[ball]).toBeCloseTo(x, 6);
  }
});

test('parts of a compound, and segments in a line, are tiles, too', () => {
  const compound = rigidWorld({ capacity: 100 });
  const parts = Array.from({ length: 40 }, (_, i) => ({ shape: box(0.5, 1), x: 0.5 * i, y: -0.5, friction: 0.5 }));
  spawnCompound(compound, { position: {}, parts });
  const segments = rigidWorld({ capacity: 100 });
  for (let i = 0; i < 40; i++) spawn(segments, { segmentWall: { ax: 0.5 * i, bx: 0.5 * i + 0.5 } });
  for (const world of [compound, segments]) {
    for (const shape of [circle(0.5), box(1, 1)]) {
      const body = spawn(world, {
        position: { x: 1, y: 0.5 },
        velocity: { x: 6 },
        collider: { shape, density: 1, friction: 0 },
      });
      const { above, below } = cross(world, body, 0.5, 18);
      expect(above).toBeLessThan(SLOP);
      expect(below).toBeLessThan(SLOP);
    }
  }
});

describe('what stands out of the floor stops a box', () => {
  const CORNERS = [-0.5, 0.5].flatMap((u) => [-0.5, 0.5].map((v) => ({ u, v })));

  /** How deep a unit square and the corner of a step, which begins at x = 6, are in each other, m. */
  function depthOf({ components: { Position, Rotation } }: PhysicsWorld, body: number, top: number): number {
    const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
    const [x, y] = [Position.x[body], Position.y[body]];
    const depths = CORNERS.map(({ u, v }) => Math.min(x + c * u - s * v - 6, top - (y + s * u + c * v)));
    const [dx, dy] = [6 - x, top - y];
    return Math.max(...depths, 0.5 - Math.max(Math.abs(c * dx + s * dy), Math.abs(c * dy - s * dx)));
  }

  it.each([2, 0.5, 0.1, 0.02, 0.01])('a wall or a step of %s m', (top) => {
    for (const [angle, spin] of [0, 0.05, 0.3, -0.2, Math.PI / 4].flatMap((each) => [-1, 0, 1].map((w) => [each, w]))) {
      const world = rigidWorld({ capacity: 50 });
      layTiles(world, 6, 0);
      // So long that a box which tips over onto a low step stays on it.
      spawn(world, { position: { x: 16, y: top - 1 }, collider: { shape: box(20, 2), friction: 0 } });
      const body = spawn(world, {
        position: { x: 4, y: 0.5 * (Math.abs(Math.cos(angle)) + Math.abs(Math.sin(angle))) },
        rotation: angle,
        velocity: { x: 2 },
        angularVelocity: { z: spin },
        collider: { shape: box(1, 1), density: 1, friction: 0 },
      });
      let depth = 0;
      for (let i = 0; i < 180; i++) {
        step(world, DT);
        depth = Math.max(depth, depthOf(world, body, top));
      }
      expect(depth).toBeLessThan(2 * SLOP);
      if (angle === 0 && spin === 0) expect(world.components.Position.x[body]).toBeLessThan(5.5 + SLOP);
    }
  });
});
