import { expect, it } from 'vitest';
import { tumblingPeriod } from './free-rotation.ts';

it('gives the precession of a nearly symmetric top, and that of small wobbles', () => {
  // Moments 1, 2, 3 and a spin along z: small wobbles have the rate ω √((I₃ - I₁)(I₃ - I₂)/(I₁ I₂)) = 4 √(2/2) rad/s.
  const period = tumblingPeriod({ x: 1, y: 2, z: 3 }, { x: 0, y: 1e-4, z: 4 });
  expect(period).toBeCloseTo((2 * Math.PI) / 4, 6);
  // And about x: ω √((I₂ - I₁)(I₃ - I₁)/(I₂ I₃)) = 6 √(2/6).
  const other = tumblingPeriod({ x: 1, y: 2, z: 3 }, { x: 6, y: 1e-4, z: 0 });
  expect(other).toBeCloseTo((2 * Math.PI) / (6 * Math.sqrt(1 / 3)), 6);
});
