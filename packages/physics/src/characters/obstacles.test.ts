// What stops characters, and what does not.
import {
  box,
  boxWalls,
  capsule,
  createRandom,
  moveCharacter,
  overlapShape,
  polygon,
  spawn,
  spawnChain,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import {
  addCharacter,
  HALF,
  MARGIN,
  RADIUS,
  right,
  STANDS,
  walk,
  worldWithFloor,
} from '../../../../test/support/character-world.ts';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('%s', (precision) => {
  test('it stops a margin before a wall, and falls beside one as if it were free', () => {
    const world = worldWithFloor({ precision });
    spawn(world, { position: { x: 3, y: 10 }, collider: { shape: box(1, 20) } });
    const stopped = walk(world, addCharacter(world, 0, STANDS), 120, right(4));
    expect(stopped.x).toBeCloseTo(2.5 - RADIUS - MARGIN, 4);
    const [floor, wall] = stopped.motion.contacts;
    expect(floor).toMatchObject({ body: 1, isWall: false, nx: expect.closeTo(0, 6), ny: expect.closeTo(1, 6) });
    expect(floor.y).toBeCloseTo(0, 6);
    expect(wall).toMatchObject({ body: 2, isWall: false, nx: expect.closeTo(-1, 6), ny: expect.closeTo(0, 6) });
    expect(wall.x).toBeCloseTo(2.5, 6);
    const falling = walk(world, addCharacter(world, 2, 10), 60, right(4));
    expect(falling.x).toBeCloseTo(2.5 - RADIUS - MARGIN, 4);
    expect(falling.y).toBeCloseTo(10 - (G * 60 * 61 * DT * DT) / 2, 3);
  });

  test.each([0, 0.3, 0.5])('a wall of flush tiles, %f m up, holds no jump and no fall', (offset) => {
    const [free, beside] = [false, true].map((tiled) => {
      const world = worldWithFloor({ precision });
      for (let i = -10; tiled && i < 20; i++) {
        spawn(world, { position: { x: 1, y: i + offset }, collider: { shape: box(1, 1) } });
      }
      const id = addCharacter(world, 0.5 - RADIUS - MARGIN, STANDS);
      const against = (i: number) => ({ x: 3, ...(i === 0 ? { jump: 12 } : {}) });
      return walk(world, id, 120, against);
    });
    // The same additions, but for roundings of the horizontal part that an oblique normal would turn.
    for (const [i, height] of beside.heights.entries()) expect(height).toBeCloseTo(free.heights[i], 4);
    for (const { nx, ny } of beside.motion.contacts) expect(Math.abs(nx * ny)).toBeLessThan(1e-6);
  });

  test('a ceiling ends a jump', () => {
    const world = worldWithFloor({ precision });
    spawn(world, { position: { y: 2.5 }, collider: { shape: box(4, 1) } });
    const { heights } = walk(world, addCharacter(world, 0, STANDS), 60, (i) => (i === 0 ? { jump: 9 } : {}));
    expect(Math.max(...heights)).toBeCloseTo(2 - HALF - MARGIN, 4);
  });

  test.each([20, 300, 2000])('at %f m/s it does not pass a wall of 5 cm', (speed) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { x: 40 }, collider: { shape: box(0.05, 10) } });
    const id = addCharacter(world, 0, 0);
    for (let i = 0; i < 200; i++) {
      moveCharacter(world, id, { x: speed }, DT);
      step(world, DT);
    }
    expect(world.components.Position.x[id]).toBeCloseTo(40 - 0.025 - RADIUS - MARGIN, 3);
  });

  test('walls of a box and of segments, and terrain, are obstacles', () => {
    const world = rigidWorld({ precision, walls: [boxWalls({ min: { x: -5, y: 0 }, max: { x: 5, y: 9 } })] });
    spawn(world, { segmentWall: { ax: 3, ay: 0, bx: 3, by: 4 } });
    expect(walk(world, addCharacter(world, -4, 2), 60, right(-3)).x).toBeCloseTo(-5 + RADIUS + MARGIN, 4);
    const walked = walk(world, addCharacter(world, 0, 2), 120, right(3));
    expect(walked.x).toBeCloseTo(3 - RADIUS - MARGIN, 4);
    expect(walked.y).toBeCloseTo(STANDS, 4);

    const hills = rigidWorld({ precision });
    const outline = Array.from({ length: 41 }, (_, i) => ({ x: 20 - i, y: Math.sin(0.7 * (20 - i)) }));
    spawnChain(hills, outline, { friction: 0.6 });
    const hiker = walk(hills, addCharacter(hills, -15, 3), 600, right(3));
    expect(hiker.x).toBeGreaterThan(5);
    expect(hiker.grounded.slice(90, 500)).not.toContain(false);
  });

  test('a one-way platform lets it through from below, and holds it', () => {
    const world = worldWithFloor({ precision });
    const platform = spawn(world, { position: { y: 1.5 }, collider: { shape: box(3, 0.1), oneWay: true } });
    const { motion, y } = walk(world, addCharacter(world, 0, STANDS), 120, (i) => (i === 0 ? { jump: 8 } : {}));
    expect(motion.ground).toBe(platform);
    expect(y).toBeCloseTo(1.55 + STANDS, 4);
  });

  test('one that jumps not quite through a one-way platform, or starts to fall through it, falls as if it were free', () => {
    const fall = (oneWay: boolean) => {
      const world = worldWithFloor({ precision });
      if (oneWay) spawn(world, { position: { y: 1.5 }, collider: { shape: box(3, 0.1), oneWay } });
      // Its feet rise to 1.43 m, in a platform with its top at 1.55 m.
      return walk(world, addCharacter(world, 0, STANDS), 90, (i) => (i === 0 ? { jump: 5.2 } : {})).heights;
    };
    const free = fall(false);
    for (const [i, height] of fall(true).entries()) expect(height).toBeCloseTo(free[i], 6);

    const world = worldWithFloor({ precision });
    spawn(world, { position: { y: 3 }, collider: { shape: box(4, 0.1), oneWay: true, layers: 2 } });
    const id = addCharacter(world, 0, 3.05 + STANDS, { mask: 3 });
    const { mask } = world.components.Collider;
    const { y } = walk(world, id, 90, (i) => {
      // Until it is more than two margins lower: 5 steps are g t²/2 > 3 cm.
      mask[id] = i < 5 ? 1 : 3;
      return {};
    });
    expect(y).toBeCloseTo(STANDS, 4);
  });

  test('layers, groups and sensors decide what stops it', () => {
    const world = worldWithFloor({ precision });
    const wall = (x: number, collider: object) =>
      spawn(world, { position: { x, y: 2 }, collider: { shape: box(0.2, 4), ...collider } });
    wall(2, { sensor: true });
    wall(3, { layers: 2 });
    wall(4, { group: -7 });
    wall(5, { layers: 2, group: 5 });
    wall(6, {});
    const own = { mask: 1, group: -7 };
    expect(walk(world, addCharacter(world, 0, STANDS, own), 150, right(4)).x).toBeCloseTo(5.9 - RADIUS - MARGIN, 4);
    const grouped = { mask: 1, group: 5 };
    expect(walk(world, addCharacter(world, 0, STANDS, grouped), 150, right(4)).x).toBeLessThan(4);
  });

  test('among random obstacles it never enters one', () => {
    const narrower = capsule(2 * (HALF - RADIUS), RADIUS - MARGIN / 2);
    const wider = capsule(2 * (HALF - RADIUS), RADIUS + 0.05);
    for (let seed = 1; seed <= 8; seed++) {
      const random = createRandom(seed);
      const between = (low: number, high: number) => random.uniform(low, high);
      const world = rigidWorld({ precision, walls: [boxWalls({ min: { x: -8, y: -8 }, max: { x: 8, y: 8 } })] });
      const pentagon = polygon([0, 1, 2, 3, 4].map((i) => ({ x: 1.2 * Math.cos(i * 1.3), y: Math.sin(i * 1.3) })));
      for (let i = 0; i < 40; i++) {
        const place = { position: { x: between(-8, 8), y: between(-8, 8) }, rotation: { angle: between(-3, 3) } };
        const shapes = [box(between(0.2, 3), 0.4), capsule(between(0.2, 3), 0.2), pentagon];
        spawn(world, { ...place, collider: { shape: shapes[i % 3] } });
      }
      step(world, DT);
      const place = () => ({ x: between(-7, 7), y: between(-7, 7), angle: Math.PI / 2 });
      let start = place();
      while (overlapShape(world, wider, start).length > 0) start = place();
      const id = addCharacter(world, start.x, start.y);
      const { Position } = world.components;
      let velocity = { x: 0, y: 0 };
      for (let i = 0; i < 240; i++) {
        const wanted = 8 * Math.sin(i / 17 + seed);
        const jump = i % 50 === 49 ? 8 : velocity.y - G * DT;
        velocity = moveCharacter(world, id, { x: wanted, y: jump }, DT, { stepHeight: 0.25 }).velocity;
        step(world, DT);
        const pose = { x: Position.x[id], y: Position.y[id], angle: Math.PI / 2 };
        expect(overlapShape(world, narrower, pose, { ignore: id }), `seed ${seed}, step ${i}`).toEqual([]);
      }
    }
  });
});
