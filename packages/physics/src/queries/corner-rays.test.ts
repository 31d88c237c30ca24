// Rays to a corner: two edges end there, and the ray meets one of them however coordinates are rounded.
import {
  cos,
  createPhysicsWorld,
  despawn,
  type Precision,
  polygon,
  rayCast,
  sin,
  spawn,
  spawnChain,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';

describe.each(['f32', 'f64'] as const)('in %s a ray', (precision: Precision) => {
  it.each([3, 4, 5, 6, 8])('through a corner to the middle of a polygon of %d corners meets it', (count) => {
    const world = createPhysicsWorld({ precision, capacity: 4 });
    const corners = Array.from({ length: count }, (_, i) => (2 * Math.PI * i) / count);
    const shape = polygon(corners.map((angle) => ({ x: cos(angle), y: sin(angle) })));
    for (let degrees = 0; degrees < 360; degrees += 3) {
      const turned = (degrees * Math.PI) / 180;
      const id = spawn(world, { position: { x: 1, y: 2 }, rotation: turned, collider: { shape } });
      for (const angle of corners) {
        const from = { x: 1 + 5 * cos(turned + angle), y: 2 + 5 * sin(turned + angle) };
        expect(rayCast(world, from, { x: 1, y: 2 })?.body, `${degrees}° ${angle}`).toBe(id);
      }
      despawn(world, id);
    }
  });

  it('to the common end of two walls, or of two segments of a chain, meets them', () => {
    for (let i = 1; i <= 9; i++) {
      for (let k = 1; k <= 9; k++) {
        const [x, y] = [i / 10, k / 10];
        const walls = createPhysicsWorld({ precision, capacity: 4 });
        spawn(walls, { segmentWall: { ax: 0, ay: 0, bx: x, by: y } });
        spawn(walls, { segmentWall: { ax: x, ay: y, bx: 1, by: (k % 3) / 10 } });
        const chain = createPhysicsWorld({ precision, capacity: 8 });
        spawnChain(chain, [
          { x: 1.3, y: 0.1 },
          { x: 1, y: (k % 3) / 10 },
          { x, y },
          { x: 0, y: 0 },
        ]);
        for (const world of [walls, chain]) {
          expect(rayCast(world, { x, y: 5 }, { x, y: -5 }), `${x} ${y}`).toBeDefined();
        }
      }
    }
  });

  it('that passes a corner at a thousandth of its size meets nothing', () => {
    const world = createPhysicsWorld({ precision, capacity: 4 });
    const shape = polygon([0, 1, 2, 3].map((i) => ({ x: cos((i * Math.PI) / 2), y: sin((i * Math.PI) / 2) })));
    spawn(world, { position: {}, collider: { shape } });
    expect(rayCast(world, { x: 1.001, y: 5 }, { x: 1.001, y: -5 })).toBeUndefined();
    expect(rayCast(world, { x: 0.999, y: 5 }, { x: 0.999, y: -5 })).toBeDefined();
  });
});
