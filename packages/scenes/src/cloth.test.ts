import { step } from '@principia/physics';
import { expect, test } from 'vitest';
import { cloth } from './cloth.ts';

test('the threads of a cloth of 100 by 100 keep their length within a hundredth, everywhere, in a gusty breeze', () => {
  const { world, dt, stretch } = cloth.create({ dimensions: 3 });
  let worst = 0;
  for (let s = 0; s < 240; s++) {
    step(world, dt);
    // From the third second on it billows as far as it does.
    if (s >= 120 && s % 4 === 0) worst = Math.max(worst, stretch?.(world).worst ?? Infinity);
  }
  expect(worst).toBeLessThan(0.01);
});
