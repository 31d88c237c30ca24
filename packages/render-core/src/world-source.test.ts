import { createPhysicsWorld, restore, snapshot, spawn, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { worldSource } from './world-source.ts';

it('has never seen versions again after the world was brought back, though the world counts as it did', () => {
  const world = createPhysicsWorld();
  const { versions } = worldSource(world);
  const seen = new Set<string>();
  const play = () => {
    for (let i = 0; i < 5; i++) {
      seen.add(`pose ${versions.pose}`);
      seen.add(`membership ${versions.membership}`);
      spawn(world, { position: {}, velocity: {} });
      step(world, 1 / 60);
    }
  };
  const taken = snapshot(world);
  play();
  const { size } = seen;
  for (const turns of [2, 3]) {
    restore(world, taken);
    play();
    expect(seen.size).toBe(turns * size);
  }
});
