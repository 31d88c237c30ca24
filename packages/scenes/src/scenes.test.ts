import { energy, stateHash, step } from '@principia/physics';
import * as scenes from '@principia/scenes';
import { describe, expect, test, vi } from 'vitest';
import { SCENES } from './registry.ts';
import type { Scene, SceneRun } from './scene.ts';

function advance({ world, dt, advance: move }: SceneRun, steps: number): void {
  for (let s = 0; s < steps; s++) {
    if (move === undefined) step(world, dt);
    else move(world);
  }
}

/** Whether a scene can be made in three dimensions: those of rigid bodies say that they cannot. */
function isInSpace(scene: Scene): boolean {
  try {
    scene.create({ count: scene.parameters.count.min, dimensions: 3 });
    return true;
  } catch (error) {
    expect(error).toMatchObject({ code: 'E_RANGE', field: 'dimensions' });
    return false;
  }
}

describe.each(SCENES.map((scene) => [scene.name, scene] as const))('scene %s', (_, scene: Scene) => {
  const count = Math.min(500, scene.parameters.count.max);

  test.each([2, 3] as const)('is the same twice in %iD, and another with another seed', (dimensions) => {
    if (dimensions === 3 && !isInSpace(scene)) return;
    const hashOf = (seed: number) => {
      const run = scene.create({ count, dimensions, seed, precision: 'f32' });
      advance(run, 30);
      expect(run.world.faults.faults).toEqual([]);
      return stateHash(run.world);
    };
    expect(hashOf(5)).toBe(hashOf(5));
    expect(hashOf(6)).not.toBe(hashOf(5));
  });

  test.each(['f32', 'f64'] as const)('moves, and keeps its energy where it says so, in %s', (precision) => {
    const run = scene.create({ count, precision });
    const before = stateHash(run.world);
    const start = energy(run.world).total;
    advance(run, 120);
    expect(stateHash(run.world)).not.toBe(before);
    const drift = Math.abs(energy(run.world).total - start) / Math.abs(start);
    // The largest relative force error that a scene asks for is 0.005; the integrators' own error is smaller.
    if (run.losesEnergy === undefined) expect(drift).toBeLessThan(5e-3);
    else expect(Number.isFinite(energy(run.world).total)).toBe(true);
  });

  test('has the dimensions that are asked for, or refuses them', () => {
    expect(scene.create({ count, dimensions: 2 }).world.dimensions).toBe(2);
    if (isInSpace(scene)) expect(scene.create({ count, dimensions: 3 }).world.dimensions).toBe(3);
  });

  test('warns of nothing', () => {
    const warn = vi.spyOn(console, 'warn');
    try {
      advance(scene.create({ count }), 2);
      expect(warn.mock.calls).toEqual([]);
    } finally {
      warn.mockRestore();
    }
  });

  test('is made with one of whatever it counts', () => {
    const run = scene.create({ count: scene.parameters.count.min });
    advance(run, 10);
    expect(run.world.faults.faults).toEqual([]);
  });

  test('has parameters whose initial values lie in their ranges', () => {
    for (const { initial, min, max, about } of Object.values(scene.parameters)) {
      expect(initial).toBeGreaterThanOrEqual(min);
      expect(initial).toBeLessThanOrEqual(max);
      expect(about).not.toBe('');
    }
    expect(scene.description).not.toMatch(/\n/);
  });

  test('refuses what it does not know or cannot be', () => {
    expect(() => scene.create({ cuont: 3 } as never)).toThrow(/E_UNKNOWN.*"cuont".*count/);
    expect(() => scene.create({ count: 0.5 })).toThrow(/E_RANGE.*whole number/);
    expect(() => scene.create({ count: Number.NaN })).toThrow(/E_NONFINITE/);
    expect(() => scene.create({ count: '5' as never })).toThrow(/E_TYPE/);
  });
});

test('every scene of the list can be imported by itself', () => {
  for (const scene of SCENES) expect(Object.values(scenes), scene.name).toContain(scene);
});

test('most scenes are in f32, as the docstring of `precision` says', () => {
  expect(SCENES.filter(({ precision }) => precision === 'f32').length).toBeGreaterThan(SCENES.length / 2);
});

test('the solar system has states of two epochs, and refuses others', () => {
  expect(() => scenes.buildSolarSystem({ epoch: 2013 as never })).toThrow('epoch must be 2000 or 2012, got 2013');
});

test('names of scenes are unique', () => {
  expect(new Set(SCENES.map(({ name }) => name)).size).toBe(SCENES.length);
});
