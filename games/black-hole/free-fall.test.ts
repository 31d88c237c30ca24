import { expect, it } from 'vitest';
import { heightAfter } from './free-fall.ts';

it('what falls freely has the speed of free fall from rest far away', () => {
  const highest = 40;
  for (const height of [10, 25, 40]) expect(heightAfter(height, highest, 0)).toBeCloseTo(height, 12);
  expect(heightAfter(highest, highest, 1)).toBe(0);
  // ρ' = −√(2 G M/ρ): the speed times √ρ is the same everywhere.
  const rate = (height: number, part: number) => {
    const h = 1e-6;
    const [later, earlier] = [part + h, part - h].map((at) => heightAfter(height, highest, at));
    return ((earlier - later) / (2 * h)) * Math.sqrt(heightAfter(height, highest, part));
  };
  for (const height of [20, 30, 40]) expect(rate(height, 0.2) / ((2 / 3) * highest ** 1.5)).toBeCloseTo(1, 6);
});

it('draws out along the fall by √(ρ₀/ρ): tides stretch', () => {
  const [height, part] = [30, 0.4];
  const length = heightAfter(height + 1e-4, 40, part) - heightAfter(height - 1e-4, 40, part);
  expect(length / 2e-4).toBeCloseTo(Math.sqrt(height / heightAfter(height, 40, part)), 6);
});
