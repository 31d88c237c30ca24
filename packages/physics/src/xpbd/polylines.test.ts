import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
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

describe('polylines', () => {
  test.each([
    ['f32', 40, 40],
    ['f64', 40, 40],
    // These sizes have batches with unused lanes, and polylines too long for padding, which are solved as single
    // springs.
    ['f32', 7, 30],
    ['f64', 5, 12],
  ] as const)('of a hanging cloth stay unstretched with one iteration, in %s, %i by %i', (precision, columns, rows) => {
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
  });

  test.each([
    ['f32', 0],
    ['f32', 0.001],
    ['f64', 0],
    ['f64', 0.001],
  ] as const)('of ropes that branch hold rods without length, in %s, which begin %d m long', (precision, apart) => {
    const world = createPhysicsWorld({
      dimensions: 3,
      precision,
      integrator: xpbd({ substeps: 4, iterations: 2 }),
      forces: [uniformGravity(), springs()],
      capacity: 50,
    });
    const { x, y, z } = world.components.Position;
    const node = (at: number, mass: number, height = 0) =>
      spawn(world, { position: { x: at, y: height }, velocity: {}, mass });
    const rod = (a: number, b: number, length: number) =>
      spawn(world, { spring: { a, b, length, stiffness: Infinity } });
    const rope = Array.from({ length: 8 }, (_, i) => node(0.1 * i, i === 0 ? Infinity : 0.1));
    for (let i = 1; i < rope.length; i++) rod(rope[i - 1] as number, rope[i] as number, 0.1);
    const [end, second] = [rope.at(-1) as number, rope[1] as number];
    const bag = node(0.7 + apart, 1);
    rod(end, bag, 0);
    rod(second, node(0.1, 0.1, 0.1), 0.1);
    for (let s = 0; s < 300; s++) step(world, 1 / 60);
    expect(world.faults.faults).toEqual([]);
    expect(Math.hypot(x[end] - x[bag], y[end] - y[bag], z[end] - z[bag])).toBeLessThan(0.001);
    // It hangs at its length.
    expect(Math.hypot(x[end], y[end], z[end])).toBeLessThan(0.7001);
  });

  test('damp transverse waves at any tension', () => {
    // 199 links of 0.01 m: explicitly the tension would displace a body by 55 link lengths in a step.
    const { world, sheet } = hang({ columns: 4, rows: 200, spacing: 0.01 });
    const { z } = world.components.Velocity;
    sheet.nodes.forEach((node, i) => {
      if (i >= 4) z[node] = Math.floor(i / 4) % 2 === 0 ? 0.01 : -0.01;
    });
    let largest = 0;
    for (let s = 0; s < 200; s++) {
      step(world, 1 / 60);
      for (const node of sheet.nodes) largest = Math.max(largest, Math.abs(world.components.Position.z[node]));
    }
    // The lowest links carry the smallest load and swing by v √(L/g); higher links swing less.
    expect(largest).toBeLessThan(0.01 * Math.sqrt(0.01 / 10));
    expect(maxStrain(world)).toBeLessThan(1e-6);
  });

  test('of a swinging sheet gain no energy and keep their lengths', () => {
    const { world } = hang({ down: { z: 1 }, shear: 100 }, { integrator: xpbd({ substeps: 5, iterations: 1 }) });
    const start = energy(world).total;
    let [worst, highest] = [0, Number.NEGATIVE_INFINITY];
    for (let s = 0; s < 120; s++) {
      step(world, 1 / 60);
      highest = Math.max(highest, energy(world).total);
      worst = Math.max(worst, rmsStrain(world, 1e29));
    }
    // The limit is 0.1 % of the potential energy: 1 kg, 10 m/s², and a centre that falls by 1 m.
    expect(highest - start).toBeLessThan(1e-3 * 10);
    expect(worst).toBeLessThan(0.01);
  });

  test('of a free spinning sheet conserve momentum to rounding', () => {
    const { world, sheet } = hang({ pins: 'none', shear: 1000, bend: 10 }, { forces: [springs()] });
    const { Position, Velocity } = world.components;
    for (const node of sheet.nodes) {
      Velocity.x[node] = -10 * (Position.y[node] + 1) + 0.3;
      Velocity.y[node] = 10 * (Position.x[node] - 1);
    }
    const before = momentum(world);
    for (let s = 0; s < 100; s++) step(world, 1 / 600);
    const after = momentum(world);
    // 1600 bodies at up to 14 m/s; each velocity is a difference of positions rounded at 1e-16 over 1/600 s, 100
    // times.
    for (const axis of ['x', 'y', 'z'] as const) expect(Math.abs(after[axis] - before[axis])).toBeLessThan(1e-11);
  });

  test('give the same result with rows and columns exchanged', () => {
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
    // Sums have the same order up to signs; coordinates of 1 m are rounded 300 times.
    upper.forEach((place, i) => {
      for (let axis = 0; axis < 3; axis++) expect(Math.abs(place[axis] - left[i][axis])).toBeLessThan(1e-10);
    });
  });

  test.each([
    ['f32', 'level', { z: 1 }],
    ['f32', 'upright', { y: -1 }],
    ['f64', 'level', { z: 1 }],
  ] as const)(
    'of a sheet pinned at two corners keep their lengths from the first step on, in %s, released %s',
    (precision, _, down) => {
      const integrator = xpbd({ substeps: 4, iterations: 1 });
      const { world } = hang({ down, pins: 'corners', shear: 1000 }, { precision, integrator });
      for (let s = 0; s < 90; s++) {
        step(world, 1 / 60);
        // Iterations end at an error of 0.4 %; the pass solved last has 0.1 to 0.2 %.
        expect(maxStrain(world, 1e29)).toBeLessThan(0.005);
      }
    },
  );

  test('preserve the mirror symmetry of a sheet', () => {
    const { world, sheet } = hang({ columns: 15, rows: 12, corner: { x: -0.35 }, pins: 'corners' });
    for (let s = 0; s < 60; s++) step(world, 1 / 60);
    const { x, y, z } = world.components.Position;
    for (let row = 0; row < 12; row++) {
      for (let column = 0; column < 7; column++) {
        const [a, b] = [sheet.at(column, row), sheet.at(14 - column, row)];
        // Polylines are solved from one end, so the sides differ by rounding, which grows in a folding cloth.
        expect(Math.hypot(x[a] + x[b], y[a] - y[b], z[a] - z[b])).toBeLessThan(1e-6);
      }
    }
  });

  test('between two anchors at, below or beyond their length stay finite', () => {
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
