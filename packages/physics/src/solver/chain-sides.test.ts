// Chains are met from one side, between their ends: what comes from behind or passes an end goes on as in free flight, at any speed,
// and what comes from the front never gets through, also where a corner meets a point at which the chain bends away.
import { box, capsule, circle, polygon, type Shape, spawn, spawnChain, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const SUBSTEPS = 4;
/** The height of free fall after n steps: semi-implicit Euler in sub-steps of h falls by g h² (n² + n)/2. */
const fallen = (y: number, vy: number, steps: number) => {
  const n = steps * SUBSTEPS;
  const h = DT / SUBSTEPS;
  return y + vy * n * h - (G * h * h * n * (n + 1)) / 2;
};

describe('from behind', () => {
  const shapes: readonly [string, Shape][] = [
    ['a ball', circle(0.15)],
    ['a crate', box(0.3, 0.3)],
    ['a rod', capsule(0.6, 0.05)],
    ['a large ball', circle(0.5)],
  ];
  test.each(shapes)('%s passes a chain at any speed', (_, shape) => {
    for (const speed of [1, 5, 20, 100]) {
      for (let phase = 0; phase < 5; phase++) {
        const world = rigidWorld({ forces: [] });
        spawnChain(world, [{ x: 5 }, { x: -5 }]);
        const y = -3 - (phase / 5) * speed * DT;
        const b = spawn(world, { position: { y }, velocity: { y: speed }, collider: { shape, density: 1 } });
        const steps = Math.ceil(6 / (speed * DT));
        for (let i = 0; i < steps; i++) step(world, DT);
        // Once its centre is in front, the rest of it is pushed out, without a velocity.
        const ahead = world.components.Position.y[b] - (y + steps * speed * DT);
        expect(ahead).toBeGreaterThan(-1e-4);
        expect(ahead).toBeLessThan(shape.minExtent);
        expect(world.components.Velocity.y[b]).toBeCloseTo(speed, 9);
      }
    }
  });

  test('what fell through a floor that way lands on what is below', () => {
    const world = rigidWorld();
    spawnChain(world, [{ x: -5 }, { x: 5 }]);
    spawnChain(world, [
      { x: 5, y: -4 },
      { x: -5, y: -4 },
    ]);
    const b = spawn(world, { position: { y: 1 }, velocity: { y: -30 }, collider: { shape: box(1, 1), density: 1 } });
    for (let i = 0; i < 120; i++) step(world, DT);
    expect(world.components.Position.y[b]).toBeCloseTo(-3.5, 2);
  });
});

test('a ball never hangs at the open end of a chain', () => {
  for (const points of [
    [{ x: 5 }, { x: 0 }],
    [{ x: 0 }, { x: -5 }],
    [{ x: 0 }, { x: 0, y: -1 }],
    [{ x: 0, y: -1 }, { x: 0 }],
  ]) {
    for (const radius of [0.135, 0.5]) {
      for (let k = -13; k <= 13; k++) {
        for (const vx of [-1, 0, 1]) {
          const world = rigidWorld();
          const { x, y } = world.components.Position;
          spawnChain(world, points);
          const position = { x: (k / 13.5) * radius, y: 0.3 + radius };
          const b = spawn(world, { position, velocity: { x: vx, y: -5 }, mass: 1, collider: { radius } });
          for (let i = 0; i < 30; i++) step(world, DT);
          const before = { x: x[b], y: y[b], vy: world.components.Velocity.y[b] };
          step(world, DT);
          const moved = Math.hypot(x[b] - before.x, y[b] - before.y);
          expect(moved > 0 || Math.abs(before.vy) < 0.5, `x ${position.x} v ${vx}`).toBe(true);
        }
      }
    }
  }
});

test('beside the open end of a floor a ball falls freely', () => {
  const world = rigidWorld({ precision: 'f64' });
  spawnChain(world, [{ x: 5 }, { x: 0 }]);
  const b = spawn(world, { position: { x: -0.09, y: 0.3 }, velocity: { y: -5 }, mass: 1, collider: { radius: 0.135 } });
  for (let i = 0; i < 60; i++) step(world, DT);
  expect(world.components.Position.y[b]).toBeCloseTo(fallen(0.3, -5, 60), 9);
});

describe('on a point where a chain bends away', () => {
  const triangle = polygon([{ x: -0.5, y: -0.3 }, { x: 0.5, y: -0.3 }, { y: 0.6 }]);
  test.each([
    ['crates', box(1, 1)],
    ['small crates', box(0.3, 0.3)],
    ['triangles', triangle],
  ] as const)('%s come down on their corners and stay above', (_, shape) => {
    for (const slope of [0.1, 0.4]) {
      for (const offset of [-0.01, -0.005, -0.002, 0, 0.003]) {
        for (let k = 0; k < 12; k++) {
          const world = rigidWorld();
          spawnChain(world, [{ x: 4, y: -4 * slope }, {}, { x: -4, y: -4 * slope }], { friction: 0.7 });
          const angle = (k * Math.PI) / 12;
          // The lowest corner comes down at `offset`.
          const corner = lowest(shape, angle);
          const b = spawn(world, {
            position: { x: offset - corner, y: 2 },
            rotation: { angle },
            collider: { shape, density: 200, friction: 0.6 },
          });
          const { x, y } = world.components.Position;
          for (let i = 0; i < 60; i++) step(world, DT);
          expect(y[b] + slope * Math.abs(x[b]), `slope ${slope} offset ${offset} angle ${angle}`).toBeGreaterThan(0.05);
        }
      }
    }
  });
});

/** How far the lowest corner of a turned outline is beside its centre. */
function lowest(shape: Shape, angle: number): number {
  let [least, at] = [Infinity, 0];
  for (let i = 0; i < shape.vertices.length; i += 2) {
    const [px, py] = [shape.vertices[i], shape.vertices[i + 1]];
    const height = Math.sin(angle) * px + Math.cos(angle) * py;
    if (height < least) [least, at] = [height, Math.cos(angle) * px - Math.sin(angle) * py];
  }
  return at;
}
