import { centreOfMass, energy, momentum, stateHash, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { nbodyDirect, nbodyTree } from './cluster.ts';
import { galaxy } from './galaxy.ts';

describe('the cluster', () => {
  test('is in virial equilibrium with energy -1/4 in space', () => {
    const { world } = nbodyTree.create({ count: 20_000, dimensions: 3 });
    const { kinetic, potential, total } = energy(world);
    // Three and a half standard errors of a mean of squares of speeds, which spread by about their mean; and softening
    // takes (ε/a)² ln(a/ε) of the potential, 1 %, which is 2 % of the energy.
    const standardErrors = 3.5 / Math.sqrt(20_000);
    expect(Math.abs(kinetic / -potential / 0.5 - 1)).toBeLessThan(standardErrors + 0.01);
    expect(Math.abs(total / -0.25 - 1)).toBeLessThan(standardErrors + 0.02);
    const { x, y, z } = momentum(world);
    // Speeds are centred before they are rounded to f32.
    expect(Math.hypot(x, y, z)).toBeLessThan(standardErrors * 2 ** -24);
  });

  test('is in virial equilibrium in the plane', () => {
    const { world } = nbodyTree.create({ count: 20_000, dimensions: 2 });
    const { kinetic, potential } = energy(world);
    // The same standard errors; in a disc softening takes ε/2a = 3.7 % of the potential.
    expect(Math.abs(kinetic / -potential / 0.5 - 1)).toBeLessThan(3.5 / Math.sqrt(20_000) + 0.037);
  });

  test('of the law 1/r turns with half of G M² of kinetic energy, whatever its size', () => {
    const { world } = nbodyTree.create({ count: 10_000, dimensions: 2, falloff: 1 });
    // The virial of pairs that pull as 1/r is G m₁m₂ each: 2K = G M²/2.
    expect(Math.abs(energy(world).kinetic / 0.25 - 1)).toBeLessThan(3.5 / Math.sqrt(10_000));
  });

  test('stays as large as it is for a crossing time', { timeout: 60_000 }, () => {
    const count = 2000;
    const run = nbodyTree.create({ count, dimensions: 3 });
    const { world, dt } = run;
    const half = () => {
      const { x, y, z } = world.components.Position;
      const radii = Float64Array.from({ length: count }, (_, i) => Math.hypot(x[i + 1], y[i + 1], z[i + 1]));
      return radii.sort()[count / 2];
    };
    const before = half();
    for (let i = 0; i < Math.round(2.83 / dt); i++) step(world, dt);
    // The softened field is a little weaker than the one the speeds were drawn for.
    expect(Math.abs(half() / before - 1)).toBeLessThan(0.15);
    expect(run.forceError(world)).toBeLessThan(0.005);
  });

  test('by the tree goes the way it goes by the direct sum', () => {
    const [a, b] = [nbodyDirect, nbodyTree].map((scene) => {
      const { world, dt } = scene.create({ count: 1500, dimensions: 3, seed: 4 });
      for (let i = 0; i < 100; i++) step(world, dt);
      return { x: world.components.Position.x.slice(1, 1501), total: energy(world).total };
    });
    let sum = 0;
    for (let i = 0; i < 1500; i++) sum += (a.x[i] - b.x[i]) ** 2;
    expect(Math.sqrt(sum / 1500)).toBeLessThan(2e-3);
    expect(a.total / b.total).toBeCloseTo(1, 3);
  });
});

describe('the galaxy', () => {
  test.each([2, 3] as const)(
    'keeps its size, its spin and its centre in %s dimensions',
    { timeout: 60_000 },
    (dimensions) => {
      const run = galaxy.create({ count: 3000, dimensions, seed: 2 });
      const { world, dt } = run;
      const { x, y } = world.components.Position;
      const meanRadius = () => {
        let sum = 0;
        for (let i = 2; i <= 3001; i++) sum += Math.hypot(x[i], y[i]);
        return sum / 3000;
      };
      const [radius, start] = [meanRadius(), energy(world).total];
      for (let i = 0; i < 384; i++) step(world, dt);
      expect(Math.abs(meanRadius() / radius - 1)).toBeLessThan(0.15);
      expect(Math.abs(energy(world).total / start - 1)).toBeLessThan(5e-3);
      const centre = centreOfMass(world);
      expect(Math.hypot(centre.x, centre.y)).toBeLessThan(0.05);
      expect(run.forceError(world)).toBeLessThan(0.01);
    },
  );

  test.each([2, 3] as const)(
    'keeps the error of its forces below half a per cent all the while in %s dimensions',
    { timeout: 60_000 },
    (dimensions) => {
      const { world, dt, forceError, gravity } = galaxy.create({ count: 20_000, dimensions, seed: 3 });
      let sum = 0;
      for (let i = 0; i < 80; i++) {
        step(world, dt);
        if (i % 8 > 0) continue;
        const error = forceError(world);
        // One star with an error of a quarter contributes 0.25/√1024 to the error of such a sample.
        expect(error, `step ${i}`).toBeLessThan(0.01);
        sum += error ** 2;
      }
      expect(Math.sqrt(sum / 10)).toBeLessThan(0.005);
      expect(gravity.report(world).method).toBe('tree');
    },
  );

  test('is the same to the last bit for the same seed', () => {
    const hashes = [0, 1].map(() => {
      const { world, dt } = galaxy.create({ count: 5000, seed: 9 });
      for (let i = 0; i < 20; i++) step(world, dt);
      return stateHash(world);
    });
    expect(hashes[0]).toBe(hashes[1]);
  });
});
