/** A world brought back goes the same way again, to the bit: every scene, every integrator, from any moment. */
import { INTEGRATORS, restore, snapshot, stateHash, step } from '@principia/physics';
import { SCENES, type Scene, type SceneRun } from '@principia/scenes';
import { describe, expect, it } from 'vitest';
import { chaoticWorld, hashAfter } from '../support/chaos.ts';
import { kepler } from '../support/integrator-problems.ts';
import { KINDS } from '../support/worlds.ts';

function advance({ world, dt, advance: move }: SceneRun, steps: number): string[] {
  return Array.from({ length: steps }, () => {
    if (move === undefined) step(world, dt);
    else move(world);
    return stateHash(world);
  });
}

describe.each(SCENES.map((scene) => [scene.name, scene] as const))('scene %s', (_, scene: Scene) => {
  const count = Math.min(300, scene.parameters.count.max);

  it.each([0, 40])('78 a world that is restored goes the same way again from step %i', (start) => {
    const run = scene.create({ count });
    advance(run, start);
    const taken = snapshot(run.world);
    const first = advance(run, 60);
    for (let again = 0; again < 2; again++) {
      restore(run.world, taken);
      expect(run.world.time).toBe(taken.time);
      expect(advance(run, 60)).toEqual(first);
    }
  });

  it('is not changed by snapshots', () => {
    const [watched, left] = [scene.create({ count }), scene.create({ count })];
    let spare = snapshot(watched.world);
    for (let i = 0; i < 30; i++) {
      advance(watched, 1);
      spare = snapshot(watched.world, spare);
    }
    expect(stateHash(watched.world)).toBe(advance(left, 30)[29]);
  });
});

describe.each(Object.entries(INTEGRATORS))('%s', (_, record) => {
  it.each([0, 33])('78 a world that is restored goes the same way again from step %i', (start) => {
    const { world } = kepler(record.create(), 0.6);
    const run = { world, dt: 0.02 };
    advance(run, start);
    const taken = snapshot(world);
    const first = advance(run, 50);
    restore(world, taken);
    expect(advance(run, 50)).toEqual(first);
  });
});

describe.each(KINDS)('chaos, $dimensions D $precision', ({ dimensions, precision }) => {
  it('78, 79 rolling back 1 to 8 steps at every step changes nothing', { timeout: 30_000 }, () => {
    const rolled = chaoticWorld(dimensions, precision);
    const kept = [snapshot(rolled)];
    for (let i = 0; i < 240; i++) {
      hashAfter(rolled, 1);
      kept.push(snapshot(rolled));
      const back = 1 + (i % 8);
      restore(rolled, kept[Math.max(0, kept.length - 1 - back)]);
      hashAfter(rolled, Math.min(back, kept.length - 1));
      expect(rolled.tick).toBe(i + 1);
    }
    expect(stateHash(rolled)).toBe(hashAfter(chaoticWorld(dimensions, precision), 240));
  });
});
