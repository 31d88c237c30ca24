// What stands must stand: stacks of unlike weights, leaning cards, a wide pyramid; and a floor of tiles is one floor.
import { box, type PhysicsWorld, softStep, spawn, spawnChain, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** Nothing sleeps, so that everything stands by contacts alone. */
const AWAKE = { integrator: softStep({ sleepTime: 0 }) };

function addFloor(world: PhysicsWorld): void {
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(400, 1), friction: 0.6 } });
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  // Contacts with what is heavy are springs of twice the frequency of others, for the effective mass at a point: at the
  // corner of a box of mass m and inertia m/6 that is 0.4 m. Two points bear a thousand times the weight of the light box.
  test.each([
    [4, 30],
    [16, 120],
  ])('a box bears one of a thousand times its mass: %i sub-steps', (substeps, contactHertz) => {
    const world = rigidWorld({ precision, integrator: softStep({ substeps, contactHertz, sleepTime: 0 }) });
    addFloor(world);
    const light = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
    const heavy = spawn(world, { position: { y: 1.5 }, collider: { shape: box(1, 1), density: 1000, friction: 0.6 } });
    run(world, 10);
    const { Position, Rotation } = world.components;
    const give = (1000 * G) / (2 * 0.4 * (2 * Math.PI * 2 * contactHertz) ** 2);
    expect(Math.abs(0.5 - give - Position.y[light])).toBeLessThan(SLOP);
    // The points of the upper contact are nearer to the middle of the light box now, by up to a tenth of its size.
    expect(Math.abs(1.5 - 2 * give - Position.y[heavy])).toBeLessThan(0.1 * give + 2 * SLOP);
    // It leans on neither side.
    expect(Math.abs(Position.x[heavy])).toBeLessThan(0.03);
    expect(Math.abs(Rotation.angle[heavy])).toBeLessThan(0.03);
  });

  // Solved once in sub-steps as long as these, of both points of a contact one bears too much: 9 and 12 boxes lean and fall.
  test.each([
    [0.5, 14],
    [1, 16],
  ])('a column of boxes of %d m, %i high, stands for 20 s with steps of 1/30 s', (side, count) => {
    const world = rigidWorld({ precision });
    addFloor(world);
    const at = (i: number) => ({ y: (i + 0.5) * side });
    const ids = Array.from({ length: count }, (_, i) =>
      spawn(world, { position: at(i), collider: { shape: box(side, side), friction: 0.6 } }),
    );
    for (let i = 0; i < 20 * 30; i++) step(world, 1 / 30);
    const { x } = world.components.Position;
    for (const id of ids) expect(Math.abs(x[id])).toBeLessThan(side / 4);
  });

  test('a house of cards of three storeys stands for ten seconds', () => {
    const world = rigidWorld({ precision, ...AWAKE });
    addFloor(world);
    const cards = buildHouse(world, 3);
    const { Position } = world.components;
    const before = cards.map((card) => [Position.x[card], Position.y[card]]);
    run(world, 10);
    // A card that falls moves by a part of its length of 1 m.
    cards.forEach((card, i) => {
      expect(Math.hypot(Position.x[card] - before[i][0], Position.y[card] - before[i][1])).toBeLessThan(0.02);
    });
  });

  test.each([5, 25, 60])('a ball of %i m/s rolls over a thousand tiles and never leaves the floor', (speed) => {
    const world = rigidWorld({ precision, capacity: 1100 });
    const points = Array.from({ length: 1001 }, (_, i) => ({ x: 499 - 0.5 * i }));
    spawnChain(world, points, { friction: 0.6 });
    const ball = spawn(world, {
      position: { x: 0.2, y: 0.3 },
      velocity: { x: speed },
      angularVelocity: -speed / 0.3,
      collider: { radius: 0.3, density: 1, friction: 0.6 },
    });
    const { Position, Velocity } = world.components;
    let [highest, lowest] = [0, 1];
    for (let i = 0; i < 480 / (speed * DT); i++) {
      step(world, DT);
      highest = Math.max(highest, Position.y[ball] - 0.3);
      lowest = Math.min(lowest, Position.y[ball] - 0.3);
    }
    expect(highest).toBeLessThan(1e-5);
    // The floor is a spring of 60 Hz for the mass of the ball.
    expect(lowest).toBeGreaterThan((-1.1 * G) / (2 * Math.PI * 60) ** 2);
    // It rolls without slipping from the start, so nothing takes its speed, and no seam its way.
    expect(Math.abs(Velocity.x[ball] - speed)).toBeLessThan(1e-4 * speed);
    expect(Math.abs(Position.x[ball] - 480.2)).toBeLessThan(0.1);
  });

  test('a ball of 2 000 m/s does not pass a wall of 5 cm, wherever in a step it arrives', () => {
    const world = rigidWorld({ precision, forces: [] });
    spawn(world, { position: { x: 10 }, collider: { shape: box(0.05, 20) } });
    const collider = { radius: 0.05, density: 1, layers: 2, mask: 1 };
    const balls = Array.from({ length: 100 }, (_, i) =>
      spawn(world, { position: { x: -0.33 * i, y: 0.15 * (i - 50) }, velocity: { x: 2000 }, collider }),
    );
    run(world, 0.1);
    for (const ball of balls) expect(world.components.Position.x[ball]).toBeLessThan(10);
  });
});

test('a pyramid with a base of a hundred stands for a minute, awake', { timeout: 300_000 }, () => {
  const base = 100;
  const world = rigidWorld({ precision: 'f32', capacity: 6000, ...AWAKE });
  addFloor(world);
  const collider = { shape: box(1, 1), density: 1, friction: 0.6 };
  const boxes: number[] = [];
  for (let row = 0; row < base; row++) {
    for (let i = 0; i < base - row; i++) {
      boxes.push(spawn(world, { position: { x: i + row / 2 - base / 2, y: row + 0.5 }, collider }));
    }
  }
  const { Position, Rotation } = world.components;
  const before = boxes.map((id) => [Position.x[id], Position.y[id]]);
  run(world, 60);
  // Contacts are springs of 30 Hz. With k rows above it, a point bears k m g / 4 and has an effective mass of m / 3, so it
  // gives way by k · 3 g / 4 ω²; the top sinks by the sum over all rows.
  const omega = 2 * Math.PI * 30;
  const sinks = (((base * (base + 1)) / 2) * 0.75 * G) / omega ** 2;
  boxes.forEach((id, i) => {
    expect(before[i][1] - Position.y[id]).toBeLessThan(sinks);
    // It stands as long as boxes lie on two others.
    expect(Math.abs(Position.x[id] - before[i][0])).toBeLessThan(0.5);
    expect(Math.abs(Rotation.angle[id])).toBeLessThan(0.05);
  });
});

/** Pairs of leaning cards, and flat ones on each two of them, 1 m long and 2 cm thick. */
function buildHouse(world: PhysicsWorld, storeys: number): number[] {
  const [length, thickness, lean] = [1, 0.02, 0.35];
  const collider = { shape: box(length, thickness), density: 1, friction: 0.8 };
  const height = length * Math.cos(lean) + thickness * Math.sin(lean);
  const half = (length * Math.sin(lean) + thickness * Math.cos(lean)) / 2;
  const cards: number[] = [];
  const add = (x: number, y: number, angle: number) =>
    cards.push(spawn(world, { position: { x, y }, rotation: angle, collider }));
  for (let storey = 0; storey < storeys; storey++) {
    const floor = storey * (height + thickness);
    const pairs = storeys - storey;
    const left = -(pairs - 1) * 2 * half;
    for (let i = 0; i < pairs; i++) {
      const middle = left + 4 * half * i;
      add(middle - half, floor + height / 2, Math.PI / 2 - lean);
      add(middle + half, floor + height / 2, Math.PI / 2 + lean);
      if (i > 0) add(middle - 2 * half, floor + height + thickness / 2, 0);
    }
  }
  return cards;
}
