import { describe, expect, test } from 'vitest';
import { energy, momentum } from '../diagnostics/energy.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { type ClothOptions, createCloth } from '../soft-bodies/cloth.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { maxStrain, rmsStrain } from './stretch.ts';
import { xpbd } from './xpbd.ts';

const ONCE = xpbd({ iterations: 1 });

function hang(cloth: Partial<ClothOptions>, options: PhysicsWorldOptions = {}) {
  const forces = [uniformGravity({ y: -10 }), springs()];
  const world = createPhysicsWorld({ capacity: 60_000, dimensions: 3, integrator: ONCE, forces, ...options });
  const size = { corner: {}, columns: 40, rows: 40, spacing: 0.05, mass: 1 };
  return { world, sheet: createCloth(world, { ...size, ...cloth }) };
}

describe('threads', () => {
  test.each([
    ['f32', 40, 40],
    ['f64', 40, 40],
    // Strands with fewer threads than lanes, and threads too long for that, which are solved link by link instead.
    ['f32', 7, 30],
    ['f64', 5, 12],
  ] as const)(
    'of a cloth that hangs bear it unstretched with one iteration, in %s, %i by %i',
    (precision, columns, rows) => {
      const { world, sheet } = hang({ columns, rows }, { precision });
      for (let s = 0; s < 100; s++) step(world, 1 / 60);
      // Coordinates up to 2 m are rounded to 1.2e-7 m in f32; links are 0.05 m long.
      expect(maxStrain(world)).toBeLessThan(precision === 'f32' ? 1e-5 : 1e-9);
      const { x, y, z } = world.components.Position;
      for (let column = 0; column < columns; column++) {
        const foot = sheet.at(column, rows - 1);
        expect(Math.abs(y[foot] + 0.05 * (rows - 1))).toBeLessThan(1e-5);
        expect(Math.hypot(x[foot] - 0.05 * column, z[foot])).toBeLessThan(1e-5);
      }
    },
  );

  test('stay straight however taut: what moves across dies down and does not grow', () => {
    // 199 links of 0.01 m: the pull moves a body across by 55 times the length of a link in a step.
    const { world, sheet } = hang({ columns: 4, rows: 200, spacing: 0.01 });
    const { z } = world.components.Velocity;
    sheet.nodes.forEach((node, i) => {
      if (i >= 4) z[node] = Math.floor(i / 4) % 2 === 0 ? 0.01 : -0.01;
    });
    let most = 0;
    for (let s = 0; s < 200; s++) {
      step(world, 1 / 60);
      for (const node of sheet.nodes) most = Math.max(most, Math.abs(world.components.Position.z[node]));
    }
    // The lowest links, which bear least, swing by v √(L/g); those above by less.
    expect(most).toBeLessThan(0.01 * Math.sqrt(0.01 / 10));
    expect(maxStrain(world)).toBeLessThan(1e-6);
  });

  test('of a sheet that swings gain no energy and stay as long as they are', () => {
    const { world } = hang({ down: { z: 1 }, shear: 100 }, { integrator: xpbd({ substeps: 5, iterations: 1 }) });
    const start = energy(world).total;
    let [worst, highest] = [0, Number.NEGATIVE_INFINITY];
    for (let s = 0; s < 120; s++) {
      step(world, 1 / 60);
      highest = Math.max(highest, energy(world).total);
      worst = Math.max(worst, rmsStrain(world, 1e29));
    }
    // Of the 1 kg, 10 m/s² and 1 m that its middle falls.
    expect(highest - start).toBeLessThan(1e-3 * 10);
    expect(worst).toBeLessThan(0.01);
  });

  test('of a free sheet that spins keep its momentum to rounding', () => {
    const { world, sheet } = hang({ pins: 'none', shear: 1000, bend: 10 }, { forces: [springs()] });
    const { Position, Velocity } = world.components;
    for (const node of sheet.nodes) {
      Velocity.x[node] = -10 * (Position.y[node] + 1) + 0.3;
      Velocity.y[node] = 10 * (Position.x[node] - 1);
    }
    const before = momentum(world);
    for (let s = 0; s < 100; s++) step(world, 1 / 600);
    const after = momentum(world);
    // 1600 bodies at up to 14 m/s, each velocity a difference of places rounded at 1e-16 over 1/600 s, 100 times.
    for (const axis of ['x', 'y', 'z'] as const) expect(Math.abs(after[axis] - before[axis])).toBeLessThan(1e-11);
  });

  test('do not ask which of them are called rows: what hangs by its upper edge hangs alike by its left one', () => {
    const SIZE = 20;
    const places = (pins: NonNullable<ClothOptions['pins']>, gravity: { x?: number; y?: number }, isLeft: boolean) => {
      const options = {
        integrator: xpbd({ substeps: 5, iterations: 1 }),
        forces: [uniformGravity(gravity), springs()],
      };
      const { world, sheet } = hang({ columns: SIZE, rows: SIZE, pins }, options);
      const { Position, Velocity } = world.components;
      const ids = Array.from(sheet.nodes, (_, i) => {
        const [column, row] = [i % SIZE, Math.floor(i / SIZE)];
        return isLeft ? sheet.at(row, column) : sheet.at(column, row);
      });
      ids.forEach((node, i) => {
        Velocity.z[node] = 0.001 * (i % SIZE) * Math.floor(i / SIZE);
      });
      for (let s = 0; s < 60; s++) step(world, 1 / 60);
      const { x, y, z } = Position;
      return ids.map((node) => (isLeft ? [-y[node], -x[node], z[node]] : [x[node], y[node], z[node]]));
    };
    const upper = places('top', { y: -10 }, false);
    const left = places(
      Array.from({ length: SIZE }, (_, row) => [0, row] as const),
      { x: 10 },
      true,
    );
    // The same sums in the same order, up to the signs: coordinates of 1 m are rounded 300 times.
    upper.forEach((place, i) => {
      for (let axis = 0; axis < 3; axis++) expect(Math.abs(place[axis] - left[i][axis])).toBeLessThan(1e-10);
    });
  });

  test.each([
    ['f32', 'level', { z: 1 }],
    ['f32', 'upright', { y: -1 }],
    ['f64', 'level', { z: 1 }],
  ] as const)(
    'of a sheet held by two corners keep their length from the first step on, in %s, let go %s',
    (precision, _, down) => {
      const integrator = xpbd({ substeps: 4, iterations: 1 });
      const { world } = hang({ down, pins: 'corners', shear: 1000 }, { precision, integrator });
      for (let s = 0; s < 90; s++) {
        step(world, 1 / 60);
        // Turns end where no thread is off by more than one in 250; those solved last, by one in a thousand or two.
        expect(maxStrain(world, 1e29)).toBeLessThan(0.005);
      }
    },
  );

  test('leave a sheet its mirror symmetry', () => {
    const { world, sheet } = hang({ columns: 15, rows: 12, corner: { x: -0.35 }, pins: 'corners' });
    for (let s = 0; s < 60; s++) step(world, 1 / 60);
    const { x, y, z } = world.components.Position;
    for (let row = 0; row < 12; row++) {
      for (let column = 0; column < 7; column++) {
        const [a, b] = [sheet.at(column, row), sheet.at(14 - column, row)];
        // Threads are gone through from one end: that differs by rounding, which a cloth that folds lets grow.
        expect(Math.hypot(x[a] + x[b], y[a] - y[b], z[a] - z[b])).toBeLessThan(1e-6);
      }
    }
  });

  test('between two anchors no longer than they are apart, or shorter, stay finite', () => {
    for (const gap of [0.5, 0.4, 0.6]) {
      const { world, sheet } = hang(
        {
          columns: 11,
          rows: 5,
          pins: [
            [0, 0],
            [10, 0],
          ],
        },
        { precision: 'f32' },
      );
      world.components.Position.x[sheet.at(10, 0)] = gap;
      for (let s = 0; s < 100; s++) step(world, 1 / 60);
      expect(world.faults.faults).toEqual([]);
      for (const node of sheet.nodes) expect(Math.abs(world.components.Position.y[node])).toBeLessThan(2);
    }
  });
});
