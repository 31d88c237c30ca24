// A peer is worth comparing with only if it does the same work: the proofs.
import { step } from '@principia/physics';
import { attractors, nbodyDirect, particles, type SceneRun, springs } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { peersOf } from './all.ts';
import { fusedSimd } from './fused-simd.ts';
import { handWritten } from './hand-written.ts';
import type { Peer } from './peer.ts';

describe.each([2, 3] as const)('in %iD', (dimensions) => {
  // It multiplies by dt/m once where the systems divide each axis, so that results differ by roundings; a body that
  // touches a wall at the very end of a step may rebound in the next one, so that it is the mean that stays small.
  test.each([
    ['f32', 0.8, 1e-3],
    ['f64', 0.8, 1e-11],
    ['f32', 0, 1e-3],
    ['f64', 0, 1e-11],
  ] as const)(
    'the hand-fused kernel goes the same way, %s with a restitution of %d',
    { timeout: 60_000 },
    async (precision, restitution, tolerance) => {
      const run = particles.create({ count: 3000, dimensions, precision, seed: 3, restitution });
      const fused = await fusedSimd(run);
      for (let s = 0; s < 400; s++) {
        step(run.world, run.dt);
        fused.step();
      }
      const { Position } = run.world.components;
      for (const axis of ['x', 'y', 'z'] as const) {
        const ours = [Position[axis], run.world.previous.Position[axis]];
        for (const [i, theirs] of [fused.positions(axis), fused.previous(axis)].entries()) {
          let sum = 0;
          for (let id = 1; id <= 3000; id++) sum += Math.abs(theirs[id] - ours[i][id]);
          expect(sum / 3000).toBeLessThan(tolerance);
        }
      }
    },
  );

  test.each(['f32', 'f64'] as const)('the hand-fused kernel tells what is out of range, %s', async (precision) => {
    for (const spoil of [
      (run: SceneRun) => run.world.components.Position.y.fill(Number.NaN, 7, 8),
      (run: SceneRun) => run.world.components.Velocity.x.fill(Number.NaN, 7, 8),
      (run: SceneRun) => run.world.components.Velocity.x.fill(4e8, 7, 8),
      (run: SceneRun) => run.world.components.QuadraticDrag.coefficient.fill(Number.NaN, 7, 8),
    ]) {
      const run = particles.create({ count: 20, dimensions, precision });
      spoil(run);
      const fused = await fusedSimd(run);
      expect(() => fused.step()).toThrow('out of range');
    }
  });

  // Plain JavaScript rounds once a store, a kernel once an operation: in f64 the difference stays small for a while.
  test.each([
    ['particles', () => particles.create({ count: 500, dimensions, precision: 'f64' })],
    ['springs', () => springs.create({ count: 500, dimensions, precision: 'f64' })],
    ['nbody-direct', () => nbodyDirect.create({ count: 200, dimensions, precision: 'f64' })],
    ['attractors', () => attractors.create({ count: 500, dimensions, precision: 'f64' })],
  ] as const)('every peer of %s goes the same way', { timeout: 60_000 }, async (scene, create) => {
    const run: SceneRun = create();
    const made = await Promise.all(peersOf(scene).map((make) => make(run)));
    const peers = made.filter((peer) => peer !== undefined).filter(({ differs }) => differs !== true);
    expect(peers.length).toBeGreaterThan(0);
    for (let s = 0; s < 200; s++) {
      step(run.world, run.dt);
      for (const peer of peers) peer.step();
    }
    for (const peer of peers) for (const axis of ['x', 'y'] as const) expectSamePlaces(run, peer, axis);
  });
});

// Masses and coefficients of drag are spread about the loop's constants, and it bounces at the end of a step: the mean
// height and distance from the middle come out alike, to a few per cent of the box.
test.each(['f32', 'f64'] as const)(
  'the hand-written loop looks the same, %s',
  { timeout: 60_000 },
  async (precision) => {
    for (const dimensions of [2, 3] as const) {
      const run = particles.create({ count: 3000, dimensions, precision });
      const peer = await handWritten(run);
      for (let s = 0; s < 300; s++) {
        step(run.world, run.dt);
        peer.step();
      }
      const spread = (list: readonly number[]) => list.reduce((sum, x) => sum + Math.abs(x - run.side / 2), 0);
      const mean = (list: readonly number[]) => list.reduce((sum, x) => sum + x, 0) / list.length;
      for (const axis of ['x', 'y'] as const) {
        const theirs = Array.from(peer.positions(axis));
        const ours = Array.from(run.world.components.Position[axis].subarray(1, 3001));
        expect(Math.abs(mean(theirs) - mean(ours))).toBeLessThan(0.02 * run.side);
        expect(Math.abs(spread(theirs) - spread(ours)) / 3000).toBeLessThan(0.02 * run.side);
      }
    }
  },
);

function expectSamePlaces({ world }: SceneRun, peer: Peer, axis: 'x' | 'y'): void {
  const theirs = Array.from(peer.positions(axis)).filter((x) => x !== 0);
  const ours = Array.from(world.components.Position[axis]).filter((x) => x !== 0);
  const sorted = (list: number[]) => Float64Array.from(list).sort();
  const [a, b] = [sorted(theirs), sorted(ours.slice(-theirs.length))];
  let worst = 0;
  for (let i = 0; i < a.length; i++) worst = Math.max(worst, Math.abs(a[i] - b[i]));
  expect(worst, peer.name).toBeLessThan(1e-6);
}
