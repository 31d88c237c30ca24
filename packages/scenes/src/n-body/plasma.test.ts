import { energy, INTEGRATORS, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { type PlasmaRun, plasma } from './plasma.ts';

const COUNT = 2000;
const QUIET = { count: COUNT, thermal: 0, shift: 0.05, massRatio: 1e6 };
const PLACES = [2, 3] as const;

/** Where the middle of the electrons is, seen from that of the ions. */
function offset({ world, electrons, ions }: PlasmaRun) {
  const { x, y } = world.components.Position;
  const mean = (column: ArrayLike<number>, ids: Uint32Array) =>
    ids.reduce((sum, id) => sum + column[id], 0) / ids.length;
  return { x: mean(x, electrons) - mean(x, ions), y: mean(y, electrons) - mean(y, ions) };
}

/** ω_M², less what softening takes at the surface: 3ε/2 in space, ε in the plane. */
const squareOf = (dimensions: 2 | 3) => 1 - (dimensions === 3 ? 1.5 : 1) * (COUNT / 2) ** (-1 / dimensions);

/** When the electrons pass the middle first. */
function firstPassage(run: PlasmaRun): number {
  const { world, dt } = run;
  for (let before = offset(run).x; ; ) {
    step(world, dt);
    const now = offset(run).x;
    if (now <= 0) return world.time - (dt * now) / (now - before);
    before = now;
  }
}

describe('the plasma', () => {
  // What is left out is of second order in softening, 1 % of ω² in space, and the charges are a thousand lumps.
  test.each(PLACES)('rings at its plasma frequency over √3 or √2 in %iD', { timeout: 60_000 }, (dimensions) => {
    const passage = firstPassage(plasma.create({ ...QUIET, field: 0, dimensions }));
    expect(Math.abs(Math.PI / 2 / passage / Math.sqrt(squareOf(dimensions)) - 1)).toBeLessThan(0.02);
  });

  test('rings √2 times as fast where ions are as light as electrons', () => {
    const passage = firstPassage(plasma.create({ ...QUIET, field: 0, massRatio: 1 }));
    expect(Math.abs(Math.PI / 2 / passage / Math.sqrt(2 * squareOf(2)) - 1)).toBeLessThan(0.02);
  });

  test.each(PLACES)('turns in a field with both its frequencies in %iD', { timeout: 60_000 }, (dimensions) => {
    const field = 1;
    const run = plasma.create({ ...QUIET, field, dimensions });
    const { world, dt } = run;
    const start = offset(run).x;
    const root = Math.sqrt(squareOf(dimensions) + field ** 2 / 4);
    const [fast, slow] = [root + field / 2, root - field / 2];
    // Of x'' = -ω_M² x - ω_c y', y'' = -ω_M² y + ω_c x', let go at rest: electrons turn as B says, from x to y.
    for (let i = 0; i < 128; i++) {
      step(world, dt);
      const t = world.time;
      const x = (start * (fast * Math.cos(slow * t) + slow * Math.cos(fast * t))) / (fast + slow);
      const y = (start * (slow * Math.sin(fast * t) - fast * Math.sin(slow * t))) / (fast + slow);
      const now = offset(run);
      expect(Math.hypot(now.x - x, now.y - y) / start).toBeLessThan(0.06);
    }
    expect(Math.abs(offset(run).y) / start).toBeGreaterThan(0.2);
  });

  test('keeps its energy, whether Boris or another integrator turns it, and is neutral', () => {
    for (const integrator of [INTEGRATORS.boris.create(), INTEGRATORS.rungeKutta4.create()]) {
      const { world, dt, forceError } = plasma.create({ count: 1000, dimensions: 3, precision: 'f64', integrator });
      const start = energy(world).total;
      for (let i = 0; i < 128; i++) step(world, dt);
      // The direct sum at 1/64 s: second order in the passages of neighbours, which last 1/20 s.
      expect(Math.abs(energy(world).total / start - 1)).toBeLessThan(1e-3);
      expect(forceError(world)).toBeLessThan(1e-10);
      expect(Array.from(world.components.Charge.value).reduce((sum, charge) => sum + charge, 0)).toBeCloseTo(0, 12);
    }
  });
});
