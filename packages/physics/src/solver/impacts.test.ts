// Impacts that run on through bodies that touch, and bodies that are hit by several at once.
import {
  box,
  COMBINE,
  circle,
  createJoint,
  distance,
  energy,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  softStep,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, disc, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** Impulses with which a contact that was struck begins the next step, as a speed, m/s. */
const LEFT_OVER = 0.01;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  const weightless = (options: PhysicsWorldOptions = {}) => rigidWorld({ precision, forces: [], ...options });
  const everyImpact = softStep({ restitutionThreshold: 0.01, sleepTime: 0 });
  const speeds = (world: PhysicsWorld, discs: readonly number[]) =>
    discs.map((id) => world.components.Velocity.x[id] as number);

  it.each([
    [1, 1],
    [1, 5],
    [2, 3],
    [3, 5],
    [1, 50],
  ])('%i that come send as many away, from a row of %i at rest', (come, rest) => {
    // Wherever within a step, and in whichever sub-step, they meet.
    for (let way = 0; way < 1; way += 0.13) {
      const world = weightless();
      const row = Array.from({ length: rest }, (_, i) => disc(world, { x: i }));
      const hitting = Array.from({ length: come }, (_, i) => disc(world, { x: -2 - i - way * 5 * DT, vx: 5 }));
      run(world, 1);
      const wanted = [
        ...row.map((_, i) => (i < rest - come ? 0 : 5)),
        ...hitting.map((_, i) => (i < come - rest ? 5 : 0)),
      ];
      speeds(world, [...row, ...hitting]).forEach((speed, i) => {
        expect(Math.abs(speed - (wanted[i] as number))).toBeLessThan(LEFT_OVER * (rest + come));
      });
    }
  });

  it('each of a row of masses 1, 2, 4 and 8 kg hits the next as if they were apart', () => {
    const world = weightless({ integrator: everyImpact });
    const masses = [1, 2, 4, 8];
    const row = masses.map((mass, i) => disc(world, { x: i, mass, vx: i === 0 ? 6 : 0 }));
    run(world, 0.5);
    // 2 m/(m + 2 m) = 2/3 goes on at each, which throws back a third.
    const last = 6 * (2 / 3) ** 3;
    expect(Math.abs((world.components.Velocity.x[row[3] as number] as number) - last)).toBeLessThan(3 * LEFT_OVER);
    expect(energy(world).kinetic).toBeCloseTo(0.5 * 36, precision === 'f32' ? 3 : 6);
  });

  it('a disc that hits two that touch comes back with a fifth of its speed', () => {
    const world = weightless();
    const [left, right] = [disc(world, { y: 0.5 }), disc(world, { y: -0.5 })];
    const hitting = disc(world, { x: -3, vx: 5 });
    run(world, 1);
    const { x, y } = world.components.Velocity;
    // The lines of centres are 30 degrees off the way: speeds of -v/5 and twice 2 √3 v/5. The discs move on by 0.5 % of a
    // radius within the sub-step of the impact, which turns the lines by as much.
    expect(x[hitting]).toBeCloseTo(-1, 1);
    expect(Math.hypot(x[left] as number, y[left] as number)).toBeCloseTo(2 * Math.sqrt(3), 1);
    expect(Math.abs((y[left] as number) + (y[right] as number))).toBeLessThan(1e-3);
    expect(energy(world).kinetic).toBeCloseTo(12.5, 2);
  });

  it.each([0.01, 0.1, 1 / 3])('a ball of %f kg on one of 1 kg flies off faster than they fell', (mass) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -1 }, collider: { shape: box(100, 2) } });
    const below = disc(world, { y: 5.5 });
    const above = disc(world, { y: 6.1, radius: 0.1, mass });
    const { y } = world.components.Velocity;
    while ((y[above] as number) <= 0) step(world, DT);
    const v = Math.sqrt(2 * G * 5);
    // The impact is somewhere in a step, whose gravity is g Δt: the factors are those of both speeds.
    expect(Math.abs((y[above] as number) - ((3 - mass) / (1 + mass)) * v)).toBeLessThan(3 * G * DT);
    expect(Math.abs((y[below] as number) - ((1 - 3 * mass) / (1 + mass)) * v)).toBeLessThan(G * DT);
  });

  it('what lies on a floor without restitution gives way to what falls on it, and stays', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -1 }, collider: { shape: box(100, 2), restitutionCombine: COMBINE.min } });
    const lying = disc(world, { y: 0.5 });
    run(world, 0.5);
    const falling = disc(world, { y: 3.5, mass: 0.5 });
    const { y } = world.components.Velocity;
    let before = 0;
    for (; (y[falling] as number) <= 0; step(world, DT)) before = y[falling] as number;
    // (m - M)/(m + M) of its speed; the other takes the rest into the floor.
    expect(Math.abs((y[falling] as number) - -before / 3)).toBeLessThan(G * DT);
    expect(Math.abs(y[lying] as number)).toBeLessThan(LEFT_OVER);
  });

  it.each([1, 2])('a cradle of five on rods, of which %i are lifted, swings for 20 s', (lifted) => {
    const angle = 0.5;
    const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
    const balls = Array.from({ length: 5 }, (_, i) => {
      const [s, c] = i < lifted ? [Math.sin(angle), Math.cos(angle)] : [0, 1];
      const anchor = spawn(world, { position: { x: i, y: 5 } });
      const ball = disc(world, { x: i - 5 * s, y: 5 - 5 * c });
      createJoint(world, distance({ a: anchor, b: ball, length: 5 }));
      return ball;
    });
    const start = energy(world).total;
    let middle = 0;
    for (let i = 0; i < 20 / DT; i++) {
      step(world, DT);
      // Rods alone: 0.1 % in 10 s, and the gravity of half a step, ½ g Δt v/E.
      expect(Math.abs(energy(world).total / start - 1)).toBeLessThan(0.005);
      middle = Math.max(middle, Math.abs(world.components.Velocity.x[balls[2] as number] as number));
    }
    // The ball in the middle stays, but for what overlap and rods push: a tenth of the largest speed, φ √(g L).
    expect(middle).toBeLessThan(0.1 * 5 * angle * Math.sqrt(G / 5));
  });

  it.each([
    ['discs', circle(0.42)],
    ['boxes', box(0.8, 0.8)],
  ])('200 %s in a room keep their energy for ten seconds', (_, shape) => {
    const world = weightless({ integrator: everyImpact });
    for (const [x, y] of [
      [0, -9],
      [0, 9],
      [-9, 0],
      [9, 0],
    ] as const) {
      spawn(world, {
        position: { x, y },
        collider: { shape: box(x ? 2 : 40, y ? 2 : 40), restitution: 1, friction: 0 },
      });
    }
    for (let i = 0; i < 196; i++) {
      const position = { x: ((i % 14) - 6.5) * 1.07, y: (Math.floor(i / 14) - 6.5) * 1.07 };
      const velocity = { x: 4 * Math.sin(i * i), y: 4 * Math.cos(3 * i * i) };
      spawn(world, { position, velocity, mass: 1, collider: { shape, restitution: 1, friction: 0 } });
    }
    const start = energy(world).kinetic;
    let [before, gained] = [start, 0];
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      const { kinetic } = energy(world);
      gained += Math.max(0, kinetic - before);
      before = kinetic;
    }
    // A tenth of what one of the 196 bodies has, in some ten thousand impacts.
    expect(gained).toBeLessThan((0.1 * start) / 196);
    // Impacts below 1 cm/s do not bounce.
    expect(before / start).toBeGreaterThan(0.995);
  });

  it.each([
    ['discs', circle(0.42), 0.3],
    ['boxes', box(0.8, 0.8), 0.6],
    ['discs', circle(0.42), 0.9],
  ])('a heap of 400 %s comes to rest, and gains no energy', (_, shape, restitution) => {
    const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
    for (const [x, y] of [
      [0, -1],
      [-11, 20],
      [11, 20],
    ] as const) {
      spawn(world, {
        position: { x, y },
        collider: { shape: box(x ? 2 : 60, y > 0 ? 60 : 2), restitution, friction: 0.3 },
      });
    }
    for (let i = 0; i < 400; i++) {
      const position = { x: ((i % 20) - 9.5) * 0.98, y: 1 + Math.floor(i / 20) * 1.3 };
      spawn(world, {
        position,
        velocity: { x: Math.sin(i * i) },
        mass: 1,
        collider: { shape, restitution, friction: 0.3 },
      });
    }
    const start = energy(world).total;
    let before = start;
    for (let i = 0; i < 480; i++) {
      step(world, DT);
      const { total } = energy(world);
      // Overlap that is pushed out lifts what lies on it.
      expect(total - before).toBeLessThan(2e-3 * start);
      before = total;
    }
    expect(energy(world).kinetic / (400 * 0.5)).toBeLessThan(1e-3);
  });

  it('what is pressed against a wall is not hit', () => {
    const world = weightless({ forces: [uniformGravity({ x: 100 * G, y: 0 })] });
    spawn(world, { position: { x: 1 }, collider: { shape: box(1, 10), restitution: 1 } });
    const pressed = disc(world, {});
    run(world, 1);
    expect(Math.abs(world.components.Velocity.x[pressed] as number)).toBeLessThan(LEFT_OVER);
  });

  it('what slides while it bounces is slowed by μ (1 + e) times its speed into the floor', () => {
    const world = rigidWorld({ precision, forces: [uniformGravity({ y: -G })] });
    spawn(world, { position: { y: -1 }, collider: { shape: box(1000, 2), friction: 0.1 } });
    const ball = disc(world, { y: 1.5, vx: 30, restitution: 0.5, friction: 0.1 });
    const { x, y } = world.components.Velocity;
    let into = 0;
    for (; (y[ball] as number) <= 0; step(world, DT)) into = y[ball] as number;
    const slowed = 0.1 * 1.5 * -into;
    // It meets the floor faster by what it gains in a step, and velocities lag by half a sub-step.
    expect(Math.abs(30 - (x[ball] as number) - slowed)).toBeLessThan(0.1 * 1.5 * G * (DT + DT / 8));
    // A disc turns by twice that at its edge, which friction meets half the slop outside.
    const turning = (-2 * (30 - (x[ball] as number))) / 0.5;
    expect(Math.abs((world.components.AngularVelocity.z[ball] as number) / turning - 1)).toBeLessThan(
      (0.5 * SLOP) / 0.5 + 1e-3,
    );
  });

  it('a restitution of 1.5 throws back with 1.5 times the speed', () => {
    const world = weightless();
    spawn(world, { position: { x: 3 }, collider: { shape: box(1, 10), restitution: 1.5 } });
    const ball = disc(world, { vx: 4 });
    run(world, 1);
    expect(world.components.Velocity.x[ball]).toBeCloseTo(-6, 4);
  });

  it('does not notice other impacts', () => {
    const speedsBeside = (others: number) => {
      const world = weightless();
      const row = [0, 1, 2, 3].map((i) => disc(world, { x: i, restitution: 0.8 }));
      const hitting = disc(world, { x: -2, y: 0.2, vx: 5, restitution: 0.8, friction: 0.4 });
      for (let i = 0; i < others; i++) disc(world, { x: 0.9 * (i % 7), y: 40 + i * 0.7, vy: -i, restitution: 0.9 });
      run(world, 1);
      const { x, y } = world.components.Velocity;
      return [...row, hitting].flatMap((id) => [x[id], y[id]]);
    };
    expect(speedsBeside(40)).toEqual(speedsBeside(0));
  });
});
