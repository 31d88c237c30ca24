import { step } from '@principia/physics';
import { expect, test } from 'vitest';
import { rope } from './rope.ts';

test.each([
  [2, 'f32'],
  [3, 'f32'],
  [3, 'f64'],
] as const)('a rope of 1000 links that is let go does not stretch, in %s D and %s', (dimensions, precision) => {
  const { world, dt, stretch } = rope.create({ dimensions, precision });
  let worst = 0;
  for (let s = 0; s < 60; s++) {
    step(world, dt);
    worst = Math.max(worst, stretch?.(world).worst ?? Infinity);
  }
  // Coordinates of up to 8 m are rounded by 2.4e-7 m in f32, at both ends of links of 0.01 m; the solver ends at 1e-5.
  expect(worst).toBeLessThan(1e-4);
});
