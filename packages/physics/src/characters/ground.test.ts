// The ground of characters: floors, slopes, steps and edges.
import { box, moveCharacter, spawn, step } from '@principia/physics';
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
  const exact = precision === 'f64' ? 1e-9 : 2e-5;

  test('it falls, stands a margin above the floor, and walks at the wanted speed', () => {
    const world = worldWithFloor({ precision });
    const id = addCharacter(world, 0, 2);
    const fallen = walk(world, id, 60);
    expect(fallen.y).toBeCloseTo(STANDS, 4);
    expect(fallen.motion).toMatchObject({ grounded: true, ground: 1, velocity: { x: 0, y: 0 } });
    const walked = walk(world, id, 120, right(4));
    expect(walked.x).toBeCloseTo(8, 4);
    expect(walked.y).toBeCloseTo(STANDS, 4);
  });

  test('a jump rises by v²/2g, up to the half step by which the scheme is ahead', () => {
    const world = worldWithFloor({ precision });
    const { heights, grounded } = walk(world, addCharacter(world, 0, STANDS), 90, (i) => (i === 0 ? { jump: 5 } : {}));
    const rise = Math.max(...heights) - STANDS;
    expect(rise).toBeGreaterThanOrEqual((5 * 5) / (2 * G));
    expect(rise).toBeLessThan((5 * 5) / (2 * G) + 5 * DT);
    expect(grounded[0]).toBe(false);
    expect(grounded.at(-1)).toBe(true);
  });

  test('a jump that begins half a step of gravity slower rises by v²/2g', () => {
    const world = worldWithFloor({ precision });
    const jump = 5 - (G * DT) / 2;
    const { heights } = walk(world, addCharacter(world, 0, STANDS), 60, (i) => (i === 0 ? { jump } : {}));
    // Its places lie on the parabola; the highest is at most half a step from the top, and up to a margin off the floor it stood on.
    const rise = Math.max(...heights) - STANDS;
    expect(rise).toBeLessThan((5 * 5) / (2 * G) + 1e-4);
    expect(rise).toBeGreaterThan((5 * 5) / (2 * G) - (G * DT * DT) / 8 - 1e-4);
  });

  test('on tiles side by side it stays at its height', () => {
    const world = rigidWorld({ precision });
    for (let i = 0; i < 300; i++) {
      spawn(world, { position: { x: i / 2, y: -0.25 }, collider: { shape: box(0.5, 0.5) } });
    }
    const { heights, x } = walk(world, addCharacter(world, 1, STANDS), 600, right(10));
    expect(x).toBeCloseTo(101, 1);
    for (const height of heights) expect(Math.abs(height - STANDS)).toBeLessThan(exact);
  });

  test.each([0.3, 0.6, 0.85])('up a slope of %f rad it walks at its speed, and rests there', (angle) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: {}, rotation: { angle }, collider: { shape: box(200, 1) } });
    const height = 0.5 / Math.cos(angle) + (RADIUS + MARGIN) / Math.cos(angle) + HALF - RADIUS;
    const id = addCharacter(world, 0, height);
    const walked = walk(world, id, 60, right(2));
    expect(Math.hypot(walked.x, walked.y - height)).toBeCloseTo(2, 3);
    expect(walked.y - height).toBeCloseTo(walked.x * Math.tan(angle), 3);
    const rested = walk(world, id, 300);
    expect(Math.hypot(rested.x - walked.x, rested.y - walked.y)).toBeLessThan(300 * exact);
    // Downwards it does not leave the ground.
    expect(walk(world, id, 120, right(-3)).grounded).not.toContain(false);
  });

  test('a slope that is too steep is a wall to one who walks, and one who falls on it slides by g sin θ', () => {
    const world = worldWithFloor({ precision });
    spawn(world, { position: { x: 6 }, rotation: { angle: 1.1 }, collider: { shape: box(20, 0.5) } });
    const walker = walk(world, addCharacter(world, 0, STANDS), 240, right(3));
    expect(walker.y).toBeCloseTo(STANDS, 4);

    const slope = rigidWorld({ precision });
    spawn(slope, { position: {}, rotation: { angle: 1.1 }, collider: { shape: box(400, 1) } });
    const height = (0.5 + RADIUS + MARGIN) / Math.cos(1.1) + HALF - RADIUS;
    const slider = addCharacter(slope, 0, height);
    const velocity = { x: 0, y: 0 };
    for (let i = 0; i < 60; i++) {
      const motion = moveCharacter(slope, slider, { x: velocity.x, y: velocity.y - G * DT }, DT);
      Object.assign(velocity, motion.velocity);
      step(slope, DT);
    }
    const { Position } = slope.components;
    const slid = Math.hypot(Position.x[slider], Position.y[slider] - height);
    // n (n + 1)/2 steps of g sin θ dt²
    expect(slid).toBeCloseTo((G * Math.sin(1.1) * 60 * 61 * DT * DT) / 2, 2);
  });

  test('it climbs stairs up to its step height, and goes down them without leaving the ground', () => {
    const world = worldWithFloor({ precision });
    for (let i = 1; i <= 5; i++) {
      spawn(world, { position: { x: 4.5 + 0.5 * i, y: 0.1 * i }, collider: { shape: box(6, 0.2 * i) } });
    }
    const id = addCharacter(world, 0, STANDS);
    const up = walk(world, id, 180, right(2), { stepHeight: 0.25 });
    expect(up.y).toBeCloseTo(1 + STANDS, 3);
    expect(up.motion.grounded).toBe(true);
    const down = walk(world, id, 180, right(-2), { stepHeight: 0.25 });
    expect(down.y).toBeCloseTo(STANDS, 3);
    expect(down.grounded).not.toContain(false);
  });

  test('a step that is higher stops it', () => {
    const world = worldWithFloor({ precision });
    spawn(world, { position: { x: 3, y: 0.15 }, collider: { shape: box(2, 0.3) } });
    const walked = walk(world, addCharacter(world, 0, STANDS), 120, right(3), { stepHeight: 0.2 });
    expect(walked.x).toBeCloseTo(2 - RADIUS - MARGIN, 3);
    expect(walked.y).toBeCloseTo(STANDS, 3);
  });

  test('over an edge that is deeper than the snap distance it falls', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(4, 1) } });
    const walked = walk(world, addCharacter(world, 0, STANDS), 90, right(3));
    expect(walked.grounded[20]).toBe(true);
    expect(walked.motion.grounded).toBe(false);
    expect(walked.y).toBeLessThan(-1);
  });

  test('up may be any direction: it walks round a planet', () => {
    const world = rigidWorld({ precision, forces: [] });
    spawn(world, { position: {}, collider: { radius: 5 } });
    const id = spawn(world, { position: { y: 5.4 }, velocity: {}, kinematic: {}, collider: { radius: RADIUS } });
    const { Position } = world.components;
    let turned = 0;
    for (let i = 0; i < 1200; i++) {
      const [x, y] = [Position.x[id], Position.y[id]];
      // 3 m/s to the right, and 1 m/s down.
      const distanceFromCentre = Math.hypot(x, y);
      const up = { x: x / distanceFromCentre, y: y / distanceFromCentre };
      moveCharacter(world, id, { x: 3 * up.y - up.x, y: -3 * up.x - up.y }, DT, { up });
      step(world, DT);
      turned += Math.atan2(x * Position.y[id] - y * Position.x[id], x * Position.x[id] + y * Position.y[id]);
      if (i > 60) expect(Math.hypot(Position.x[id], Position.y[id]) - 5 - RADIUS).toBeCloseTo(MARGIN, 5);
    }
    // 60 m at a distance of 5.31 m from the centre, but for the chord of each step.
    expect(turned).toBeCloseTo(-60 / 5.31, 1);
  });
});
