import { describe, expect, test } from 'vitest';
import { forceOn, lawOn, read, run, single } from '../../../../test/support/laws.ts';
import {
  createPhysicsWorld,
  decodeSnapshot,
  defineLaw,
  despawn,
  encodeSnapshot,
  type Force,
  keepState,
  linearDrag,
  periodicDrive,
  pointerPull,
  powerLaw,
  randomDrive,
  restore,
  restrictForce,
  semiImplicitEuler,
  snapshot,
  spawn,
  spawnMany,
  step,
  uniformGravity,
  vec3,
  velocityVerlet,
} from '../index.ts';

describe('periodic drive', () => {
  test('is a constant force for Ω = 0, and reaches both amplitudes', () => {
    expect(lawOn(periodicDrive({ cosine: { x: 3 }, angularFrequency: 0 }), { mass: 7 }).x).toBe(3);
    const law = periodicDrive({ cosine: { x: 3 }, sine: { y: 4 }, angularFrequency: 2 });
    const { world, eid } = single([law], {});
    expect(forceOn(world, eid, Math.PI / 4).y).toBeCloseTo(4, 14);
    expect(forceOn(world, eid, Math.PI / 2).x).toBeCloseTo(-3, 14);
  });
});

/** Returns mean square velocity and position of many bodies under the same law, each with its own noise. */
function crowd(forces: Parameters<typeof single>[0], seconds: number, dt: number, body = {}) {
  const count = 4000;
  const world = createPhysicsWorld({ capacity: count, forces, integrator: velocityVerlet });
  for (let i = 0; i < count; i++) spawn(world, { position: {}, velocity: {}, mass: 2, ...body });
  run(world, seconds, dt);
  const { Position: p, Velocity: v } = world.components;
  const mean = (column: ArrayLike<number>) => {
    let sum = 0;
    for (let eid = 1; eid <= count; eid++) sum += column[eid] ** 2;
    return sum / count;
  };
  return { vx: mean(v.x), vy: mean(v.y), x: mean(p.x) };
}

const drive = (seed?: number) => randomDrive({ spectralDensity: 1, ...(seed !== undefined && { seed }) });

/** White noise of spectral density 1 with the seed 1, which is also that of the world. */
const ownNoise = defineLaw({
  name: 'noise of the test',
  force: ({ noise, dt }) => vec3(noise(1, 0).div(dt.sqrt()), noise(1, 1).div(dt.sqrt()), 0),
});

describe('random drive', () => {
  // The mean square of 4000 normal numbers has an error of √(2/4000) = 2.2 %: 8 % exceeds 3.5 standard deviations.
  const near = (value: number, expected: number) => expect(Math.abs(value / expected - 1)).toBeLessThan(0.08);

  test('a free body gains S t/m² per axis for any step', () => {
    for (const dt of [0.1, 0.01]) {
      const { vx, vy } = crowd([randomDrive({ spectralDensity: { x: 12, y: 3 } })], 2, dt);
      near(vx, (12 * 2) / 4);
      near(vy, (3 * 2) / 4);
    }
  });

  test('a damped oscillator has ⟨x²⟩ = S/(2 k c), and linear drag the temperature S/(2 c)', () => {
    for (const dt of [0.1, 0.025]) {
      const spring = powerLaw({ strength: -5, exponent: 1 });
      const { x, vx } = crowd([randomDrive({ spectralDensity: 8 }), spring, linearDrag()], 12, dt, { linearDrag: 2 });
      near(x, 8 / (2 * 10 * 2));
      near(2 * vx, 8 / (2 * 2));
    }
  });

  test('the noise depends on the seed, and not on chunks', () => {
    const path = (seed: number, precision: 'f32' | 'f64' = 'f64') => {
      const { world, at } = single([randomDrive({ spectralDensity: 1 })], {}, { seed, precision });
      run(world, 1);
      return at();
    };
    expect(path(1)).toEqual(path(1));
    expect(path(1)).not.toEqual(path(2));
    expect(path(1, 'f32').x).toBeCloseTo(path(1).x, 4);
  });

  // The mean of v² over two axes of N bodies has the relative standard error 1/√N.
  test.each([
    ['two drives', [1, 2].map((spectralDensity) => randomDrive({ spectralDensity })), 3],
    ['a drive and a law with noise', [drive(), ownNoise()], 2],
    ['two restricted drives', [restrictForce(drive(), { until: 9 }), restrictForce(drive(), { from: 0 })], 2],
    ['two seeds', [1, 2].map(drive), 2],
    ['one seed twice, with the same numbers', [7, 7].map(drive), 4],
  ] as const)('variances add: %s', (_, forces, variance) => {
    const count = 4000;
    const world = createPhysicsWorld({ capacity: count, forces });
    spawnMany(world, count, { position: {}, velocity: {}, mass: 1 });
    for (let i = 0; i < 20; i++) step(world, 0.05);
    const { x, y } = world.components.Velocity;
    let sum = 0;
    for (let i = 1; i <= count; i++) sum += x[i] * x[i] + y[i] * y[i];
    expect(Math.abs(sum / (2 * count * variance) - 1)).toBeLessThan(4 / Math.sqrt(count));
  });

  test('the numbers of a drive do not depend on forces of other kinds, nor on other worlds', () => {
    const path = (forces: Force[]) => {
      const { world, at } = single(forces);
      run(world, 1);
      return at();
    };
    const silent = randomDrive({ spectralDensity: 0, seed: 3 });
    expect(path([linearDrag(), silent, drive()])).toEqual(path([drive()]));
    expect(path([drive(), drive()])).not.toEqual(path([drive(), silent]));
  });

  test('axes and bodies are independent in 3D', () => {
    const world = createPhysicsWorld({ capacity: 3000, dimensions: 3, forces: [randomDrive({ spectralDensity: 1 })] });
    for (let i = 0; i < 3000; i++) spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 1);
    const { x, y, z } = world.components.Velocity;
    const correlation = (a: ArrayLike<number>, b: ArrayLike<number>, lag: number) => {
      let sum = 0;
      for (let i = 1; i <= 3000 - lag; i++) sum += a[i] * b[i + lag];
      return Math.abs(sum / 3000);
    };
    for (const pair of [correlation(x, y, 0), correlation(y, z, 0), correlation(x, z, 0), correlation(x, x, 1)]) {
      expect(pair).toBeLessThan(4 / Math.sqrt(3000));
    }
  });
});

describe('pointer pull', () => {
  test('moves the body to the point without overshoot, and releases it without a jump', () => {
    const hand = pointerPull({ frequency: 1 });
    const { world, eid, at, speed } = single([hand], { mass: 40 });
    hand.grab(world, eid, { x: 3, y: 4 });
    let furthest = 0;
    run(world, 3, 1 / 120, () => {
      furthest = Math.max(furthest, at().x);
    });
    expect(furthest).toBeLessThanOrEqual(3);
    expect(at().x).toBeCloseTo(3, 4);
    hand.moveTo({ x: 0 });
    step(world, 0.01);
    const before = speed();
    expect(before).toBeGreaterThan(0);
    hand.release();
    step(world, 0.01);
    expect(speed()).toBe(before);
  });

  test('has the equilibrium mg/(m ω²) below the point for every mass, and at most its maximum force', () => {
    for (const mass of [1, 100]) {
      const hand = pointerPull({ frequency: 1 });
      const { world, eid, at } = single([hand, uniformGravity({ y: -10 })], { mass });
      hand.grab(world, eid, {});
      run(world, 5);
      expect(at().y).toBeCloseTo(-10 / (2 * Math.PI) ** 2, 6);
    }
    const weak = pointerPull({ maxForce: 5 });
    const { world, eid } = single([weak]);
    weak.grab(world, eid, { x: 300, y: 400 });
    expect(forceOn(world, eid)).toMatchObject({ x: 3, y: 4 });
  });

  test('the grab goes back with the world, and to another, if it is named as state', () => {
    const make = () => {
      const hand = pointerPull({ frequency: 3 });
      const { world, eid, at } = single([hand], { mass: 1 });
      keepState(world, hand.grip);
      return { hand, world, eid, at };
    };
    const end = ({ world, at }: ReturnType<typeof make>) => {
      run(world, 0.5, 1 / 60);
      return at();
    };
    const one = make();
    const free = snapshot(one.world);
    one.hand.grab(one.world, one.eid, { x: 1 });
    one.hand.moveTo({ x: 5, y: 5 });
    run(one.world, 0.05, 1 / 60);
    const held = snapshot(one.world);
    const bytes = encodeSnapshot(held);
    const pulled = end(one);
    one.hand.release();
    restore(one.world, held);
    expect(end(one)).toEqual(pulled);
    expect(pulled.x).toBeGreaterThan(1);
    const other = make();
    restore(other.world, decodeSnapshot(other.world, bytes));
    expect(end(other)).toEqual(pulled);
    restore(one.world, free);
    expect(end(one)).toMatchObject({ x: 0, y: 0 });
  });

  test('a removed body is released, and its reused id is not grabbed', () => {
    const hand = pointerPull();
    const { world, eid } = single([hand], {}, { integrator: semiImplicitEuler });
    hand.grab(world, eid, { x: 10 });
    despawn(world, eid);
    const heir = spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 0.1);
    expect(read(world, heir).speed()).toBe(0);
    expect(() => hand.grab(world, 15, {})).toThrow(/E_STALE/);
  });
});
