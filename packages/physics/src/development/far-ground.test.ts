import { box, rigidBodies, spawn, spawnChain, step, uniformGravity } from '@principia/physics';
import { expect, it } from 'vitest';
import { warnedWorld } from '../../../../test/support/warned-world.ts';

/** Messages after a step of a world with ground at a distance, and a body that has fallen 20 km. */
function messagesAt(x: number, precision: 'f32' | 'f64'): string {
  const { world, messages } = warnedWorld({ preset: rigidBodies, precision, forces: [uniformGravity()] });
  spawnChain(world, [{ x: 5 }, { x: -5 }], {}, { position: { x } });
  spawn(world, { position: { y: -2e4 }, collider: { shape: box(1, 1), density: 1 } });
  step(world, 1 / 60);
  return messages();
}

it('ground that is too far off for f32 is warned of, and nothing else', () => {
  expect(messagesAt(2e4, 'f32')).toContain('body 1 is at (20000, 0) m');
  expect(messagesAt(8000, 'f32')).toBe('');
  expect(messagesAt(2e4, 'f64')).toBe('');
});
