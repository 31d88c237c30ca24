// Gusts against the specification: deviations, correlations and spectra, from long flights at one height and speed.
import { describe, expect, it } from 'vitest';
import { AIRCRAFT } from './aircraft.ts';
import { DrydenGusts, rollDeviation, turbulenceAt } from './dryden-gusts.ts';

const STILL = { x: 0, y: 0, z: 0 };
const FOOT = 0.3048;
const at = (height: number) => turbulenceAt(height, { level: 0, vertical: 0, ratio: 0 });

/** Gusts of unit deviation along x (u), z (v) and y (w), sampled at a step in times of the filter. */
function record(count: number, part: number, height: number, axis: 'x' | 'y' | 'z'): Float64Array {
  const { level, vertical, ratio } = at(height);
  const speed = 40;
  const dt = (part * (axis === 'y' ? vertical : level)) / speed;
  const gusts = new DrydenGusts(STILL, 1, 3);
  return Float64Array.from({ length: count }, (_, i) => {
    gusts.step(i * dt, dt, height, speed, 1, 0);
    return gusts.at((i + 1) * dt)[axis] / (axis === 'y' ? 1 : ratio);
  });
}

/** Mean of the product of values that are apart by a number of samples. */
function correlation(values: Float64Array, lag: number): number {
  let sum = 0;
  for (let i = lag; i < values.length; i++) sum += values[i] * values[i - lag];
  return sum / (values.length - lag);
}

/** One-sided spectrum at ω, per rad of the sample's time, by segments under Hann's window. */
function spectrum(values: Float64Array, dt: number, omega: number, length: number): number {
  let [sum, segments] = [0, 0];
  for (let start = 0; start + length <= values.length; start += length, segments++) {
    let [re, im, weight] = [0, 0, 0];
    for (let i = 0; i < length; i++) {
      const window = 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / length);
      re += window * values[start + i] * Math.cos(omega * i * dt);
      im += window * values[start + i] * Math.sin(omega * i * dt);
      weight += window * window;
    }
    sum += ((re * re + im * im) * dt) / (Math.PI * weight);
  }
  return sum / segments;
}

describe('scales and deviations', () => {
  it('are those of the specification below 1000 feet, and continuous above', () => {
    // By hand at 100 ft: 0.177 + 0.0823 = 0.2593; ^1.2 = 0.19798, ^0.4 = 0.58280.
    const low = at(100 * FOOT);
    expect(low.vertical).toBeCloseTo(100 * FOOT, 10);
    expect(low.level / FOOT).toBeCloseTo(100 / 0.2593 ** 1.2, 8);
    expect(low.ratio).toBeCloseTo(1 / 0.2593 ** 0.4, 10);
    // 0.177 + 0.823 = 1: the same in all directions.
    const border = at(1000 * FOOT);
    expect(border.ratio).toBeCloseTo(1, 12);
    expect(border.level / FOOT).toBeCloseTo(1000, 8);
    expect(at(1500 * FOOT).vertical / FOOT).toBeCloseTo(1375, 8);
    expect(at(9000).level / FOOT).toBeCloseTo(1750, 8);
  });
});

// 20 samples per time of the filter, over 10 000 times of it.
const [PART, COUNT] = [0.05, 200_000];

describe('a long flight', () => {
  // Of n times of correlation the variance has a standard error of √(2/n) = 1.4 %; 6 % are more than four of them.
  it.each(['x', 'y', 'z'] as const)('has the deviation of the specification along %s', (axis) => {
    const values = record(COUNT, PART, 60, axis);
    expect(Math.abs(correlation(values, 0) - 1)).toBeLessThan(0.06);
  });

  it('has the correlation e^(−s) along the course, and e^(−s) (1 − s/2) across it', () => {
    const [along, across] = [record(COUNT, PART, 60, 'x'), record(COUNT, PART, 60, 'z')];
    for (const lag of [10, 20, 40]) {
      const s = lag * PART;
      expect(Math.abs(correlation(along, lag) - Math.exp(-s))).toBeLessThan(0.06);
      expect(Math.abs(correlation(across, lag) - Math.exp(-s) * (1 - s / 2))).toBeLessThan(0.06);
    }
  });

  it('has the spectra of Dryden', () => {
    const [along, across] = [record(COUNT, PART, 60, 'x'), record(COUNT, PART, 60, 'y')];
    for (const omega of [0.5, 1, 2, 5]) {
      const square = omega * omega;
      // Segments of 40 times: 250 of them have a standard error of 6.3 %, and the window spreads over 0.16 rad.
      const near = (value: number, exact: number) =>
        expect(Math.abs(value / exact - 1), `ω = ${omega}`).toBeLessThan(0.25);
      near(spectrum(along, PART, omega, 800), 2 / Math.PI / (1 + square));
      near(spectrum(across, PART, omega, 800), (1 + 3 * square) / (1 + square) ** 2 / Math.PI);
    }
  });

  it('rolls as the specification says: its deviation is the integral of its spectrum, and it forgets over 4 b/π', () => {
    const { span } = AIRCRAFT;
    const { vertical } = at(60);
    // Φ_p of MIL-F-8785C, summed to 400 times where it has fallen by half; what is left is 2/(400 π) of it.
    const scale = (4 * span) / Math.PI;
    const [count, part] = [400_000, 0.001 / scale];
    let sum = 0;
    for (let i = 0; i < count; i++) sum += part / (1 + (scale * (i + 0.5) * part) ** 2);
    const variance = (sum / vertical) * 0.8 * ((Math.PI * vertical) / (4 * span)) ** (1 / 3);
    expect(rollDeviation(vertical) ** 2 / variance).toBeCloseTo(1, 2);
    const speed = 40;
    const dt = (PART * scale) / speed;
    const gusts = new DrydenGusts(STILL, 2, 3);
    const rolls = Float64Array.from({ length: COUNT }, (_, i) => {
      gusts.step(i * dt, dt, 60, speed, 1, 0);
      return gusts.roll / (2 * rollDeviation(vertical));
    });
    expect(Math.abs(correlation(rolls, 0) - 1)).toBeLessThan(0.06);
    expect(Math.abs(correlation(rolls, 20) - Math.exp(-1))).toBeLessThan(0.06);
  });

  it('does not depend on the step but by chance: exact filters have the same variance at any', () => {
    for (const part of [0.002, 0.5]) {
      const values = record(part < 0.01 ? 1_000_000 : 20_000, part, 60, 'z');
      // 2000 and 10 000 times: standard errors of 3.2 % and 1.4 %.
      expect(Math.abs(correlation(values, 0) - 1)).toBeLessThan(0.13);
    }
  });

  it('is the same for the same seed, and blows about the mean wind', () => {
    const draw = (seed: number) => {
      const gusts = new DrydenGusts({ x: 0, y: 0, z: 4 }, 2, seed);
      let sum = 0;
      for (let i = 0; i < 1000; i++) {
        gusts.step(i / 240, 1 / 240, 50, 40, 0, 1);
        sum += gusts.at((i + 0.5) / 240).z;
      }
      return sum;
    };
    expect(draw(5)).toBe(draw(5));
    expect(draw(5)).not.toBe(draw(6));
  });
});
