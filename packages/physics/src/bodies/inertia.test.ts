import { expect, test } from 'vitest';
import { ballInertia, ballMass, discInertia, discMass } from './inertia.ts';

test('a shape cut into rings or shells has the mass and the moment of inertia of the formulas', () => {
  const [density, radius, rings] = [7, 1.5, 20_000];
  let [discM, discI, ballM, ballI] = [0, 0, 0, 0];
  for (let i = 0; i < rings; i++) {
    const r = ((i + 0.5) * radius) / rings;
    const ring = density * 2 * Math.PI * r * (radius / rings);
    const shell = density * 4 * Math.PI * r * r * (radius / rings);
    discM += ring;
    discI += ring * r * r;
    ballM += shell;
    // A thin shell has the moment 2 m r²/3.
    ballI += (2 / 3) * shell * r * r;
  }
  // The midpoint rule errs by at most a few times (radius/rings)².
  expect(discMass(density, radius) / discM).toBeCloseTo(1, 8);
  expect(ballMass(density, radius) / ballM).toBeCloseTo(1, 8);
  expect(discInertia(discM, radius) / discI).toBeCloseTo(1, 8);
  expect(ballInertia(ballM, radius) / ballI).toBeCloseTo(1, 8);
});

test.each([discInertia, ballInertia, discMass, ballMass])('%o refuses what is no mass, density or radius', (shape) => {
  for (const bad of [NaN, Infinity]) {
    expect(() => shape(bad, 1)).toThrow(expect.objectContaining({ code: 'E_NONFINITE' }));
    expect(() => shape(1, bad)).toThrow(expect.objectContaining({ code: 'E_NONFINITE' }));
  }
  for (const bad of [0, -1]) {
    expect(() => shape(bad, 1)).toThrow(expect.objectContaining({ code: 'E_RANGE' }));
    expect(() => shape(1, bad)).toThrow(expect.objectContaining({ code: 'E_RANGE' }));
  }
  expect(() => shape('1' as never, 1)).toThrow(expect.objectContaining({ code: 'E_TYPE' }));
});
