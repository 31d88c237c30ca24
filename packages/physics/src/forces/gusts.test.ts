import { describe, expect, test } from 'vitest';
import { forceOn, lawOn, run, single } from '../../../../test/support/laws.ts';
import {
  correlatedGusts,
  createPhysicsWorld,
  createRandom,
  linearDrag,
  PhysicsError,
  spawn,
  turbulentDrag,
} from '../index.ts';

describe('correlated gusts', () => {
  const options = { mean: { x: 5 }, deviation: { x: 2, y: 3 }, time: 0.5, seed: 7 };

  test('have the given mean, deviation and correlation time at any sampling rate', () => {
    // Standard errors over a time T of a process with correlation time τ, relative to σ: √(2τ/T) for the mean, half
    // of that for the deviation, and √((1 - 3e⁻²) τ/T) for the correlation at τ (Bartlett 1946). The bounds are 3.5
    // of each.
    const [duration, tau] = [8000, 0.5];
    const mean = 3.5 * Math.sqrt((2 * tau) / duration);
    const correlation = 3.5 * Math.sqrt(((1 - 3 * Math.exp(-2)) * tau) / duration);
    // Linear interpolation between nodes τ/16 apart increases the correlation by e⁻¹/48.
    const straight = Math.exp(-1) / 48;
    for (const dt of [0.1, 0.2]) {
      const wind = correlatedGusts(options);
      const ahead = correlatedGusts(options);
      const lag = 0.5;
      let [n, sum, square, product] = [0, 0, 0, 0];
      for (let t = 0; t < duration; t += dt) {
        const now = wind(t).y;
        const later = ahead(t + lag).y;
        n++;
        sum += now;
        square += now * now;
        product += now * later;
      }
      expect(Math.abs(sum / n)).toBeLessThan(3 * mean);
      expect(Math.abs(Math.sqrt(square / n) - 3)).toBeLessThan((3 * mean) / 2);
      expect(Math.abs(product / square - Math.exp(-1) - straight)).toBeLessThan(correlation);
    }
  });

  test('are a function of time: the same bits in any order and from any start', () => {
    const [forward, back] = [correlatedGusts(options), correlatedGusts(options)];
    const times = Array.from({ length: 300 }, (_, i) => i * 0.137);
    const read = (wind: typeof forward, t: number) => ({ ...wind(t) });
    const first = times.map((t) => read(forward, t));
    const last = [...times].reverse().map((t) => read(back, t));
    expect(last.reverse()).toEqual(first);
    expect(read(correlatedGusts({ ...options, seed: 8 }), 1)).not.toEqual(first[7]);
    expect(first[3].z).toBe(0);
  });

  test('move a body under linear drag at the mean wind', () => {
    const { world, at } = single([linearDrag(correlatedGusts({ ...options, time: 0.05 }))], { linearDrag: 10 });
    run(world, 800, 0.02);
    // The bound is 3.5 standard errors σ √(2τ/T) of the mean wind, plus the 0.1 s in which the body accelerates.
    expect(Math.abs(at().x / 800 - 5)).toBeLessThan(3.5 * 2 * Math.sqrt((2 * 0.05) / 800) + (5 * 0.1) / 800);
  });
});

describe('turbulent drag', () => {
  const options = { deviation: 2, largest: 10, seed: 3 };
  const wind = (law = turbulentDrag(options), x = 0, y = 0, z = 0, dimensions: 2 | 3 = 2) => {
    const at = dimensions === 2 ? { x, y } : { x, y, z };
    return lawOn(law, { position: at, linearDrag: 1 }, { dimensions });
  };

  test('the velocity field is free of divergence in 2D and 3D', () => {
    const law = turbulentDrag(options);
    // Its gradients are about 40 1/s.
    const h = 5e-4;
    for (const [x, y] of [
      [0, 0],
      [3, -7],
      [120, 45],
    ]) {
      const flat = (wind(law, x + h, y).x - wind(law, x - h, y).x + wind(law, x, y + h).y - wind(law, x, y - h).y) / h;
      expect(Math.abs(flat)).toBeLessThan(1e-3);
      const solid =
        (wind(law, x + h, y, 1, 3).x - wind(law, x - h, y, 1, 3).x) / h +
        (wind(law, x, y + h, 1, 3).y - wind(law, x, y - h, 1, 3).y) / h +
        (wind(law, x, y, 1 + h, 3).z - wind(law, x, y, 1 - h, 3).z) / h;
      expect(Math.abs(solid)).toBeLessThan(1e-3);
    }
  });

  test('each component has the given deviation over a wide space, for any seed, and no two are correlated', () => {
    const count = 2500;
    for (const dimensions of [2, 3] as const) {
      for (const seed of [1, 2, 3, 4]) {
        const forces = [turbulentDrag({ ...options, seed })];
        const world = createPhysicsWorld({ capacity: 5000, dimensions, forces });
        const random = createRandom(9);
        const coordinate = () => random.uniform(-1e4, 1e4);
        for (let i = 0; i < count; i++) {
          const position = { x: coordinate(), y: coordinate(), ...(dimensions === 3 ? { z: coordinate() } : {}) };
          spawn(world, { position, velocity: {}, mass: 1, linearDrag: 1 });
        }
        forceOn(world, 1);
        const { x, y, z } = world.scratch.force;
        const columns = (dimensions === 3 ? [x, y, z] : [x, y]).map((column) => [...column.subarray(1, count + 1)]);
        const meanProduct = (a: number[], b: number[]) => a.reduce((sum, value, i) => sum + value * b[i], 0) / count;
        // 3.5 standard errors of a sample: √(2/n) of the mean square, 1/√n of the correlation. Directions drawn at random
        // alone would be off by 1/√32 of the amplitude.
        for (const [i, a] of columns.entries()) {
          expect(Math.abs(a.reduce((sum, value) => sum + value, 0) / count)).toBeLessThan(2 * (3.5 / Math.sqrt(count)));
          expect(Math.abs(meanProduct(a, a) / 4 - 1)).toBeLessThan(3.5 * Math.sqrt(2 / count));
          for (const b of columns.slice(0, i)) {
            expect(Math.abs(meanProduct(a, b) / 4)).toBeLessThan(3.5 / Math.sqrt(count));
          }
        }
      }
    }
    // A single wave cannot have two equal components.
    expect(Math.abs(wind(turbulentDrag({ ...options, modes: 1 })).x)).toBeLessThan(4);
  });

  test('the field does not depend on the frame rate, and changes with time', () => {
    const after = (dt: number) => {
      const { world, eid } = single([turbulentDrag(options)], { linearDrag: 1e-12 });
      run(world, 4, dt);
      const { x, y } = forceOn(world, eid);
      return [x, y];
    };
    const [coarse, fine] = [after(0.5), after(0.01)];
    expect(coarse[0]).toBeCloseTo(fine[0], 22);
    expect(coarse[1]).toBeCloseTo(fine[1], 22);
    expect(coarse[0]).not.toBeCloseTo(after(4)[0] * 2, 13);
  });

  test('f32 has the same velocity field', () => {
    const force = (precision: 'f32' | 'f64') =>
      lawOn(turbulentDrag(options), { position: { x: 3, y: 4 }, velocity: { x: 1 }, quadraticDrag: 1 }, { precision });
    expect(force('f32').x).toBeCloseTo(force('f64').x, 3);
    expect(force('f32').y).toBeCloseTo(force('f64').y, 3);
  });

  test('an invalid spectrum is refused', () => {
    expect(() => turbulentDrag({ ...options, smallest: 11 })).toThrow(PhysicsError);
    expect(() => turbulentDrag({ ...options, modes: 0 })).toThrow(PhysicsError);
    expect(() => correlatedGusts({ deviation: {}, time: 0 })).toThrow(PhysicsError);
  });
});
