import { aliveCount, emitterCounts, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { emitters } from './emitters.ts';

test.each([2, 3] as const)('a tenth of the sparks is born and ends every second, in %iD', (dimensions) => {
  const { world, dt, emitters: fountains } = emitters.create({ count: 3000, dimensions });
  const sum = (of: (emitter: (typeof fountains)[0]) => number) => fountains.reduce((total, f) => total + of(f), 0);
  const { membership } = world.versions;
  const living: number[] = [];
  const [born, ended] = [sum((f) => emitterCounts(f).born), sum((f) => emitterCounts(f).ended)];
  for (let s = 0; s < 600; s++) {
    step(world, dt);
    living.push(sum(aliveCount));
  }
  expect(Math.min(...living)).toBeGreaterThan(2850);
  expect(Math.max(...living)).toBeLessThan(3150);
  expect(sum((f) => emitterCounts(f).born) - born).toBeGreaterThan(2950);
  expect(sum((f) => emitterCounts(f).ended) - ended).toBeGreaterThan(2850);
  expect(sum((f) => emitterCounts(f).dropped)).toBe(0);
  expect(world.versions.membership).toBe(membership);
});
