// A peer is worth comparing with only if it does the same work: the proofs.
import { stateHash, step } from '@principia/physics';
import { attractors, nbodyDirect, particles, type SceneRun, springs } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { peersOf } from './all';
import { fusedStep } from './fused-simd';
import type { Peer } from './peer';

describe.each([2, 3] as const)('in %iD', (dimensions) => {
  test.each(['f32', 'f64'] as const)(
    'the hand-fused kernel ends in the same state to the last bit, %s',
    { timeout: 60_000 },
    async (precision) => {
      const make = () => particles.create({ count: 3000, dimensions, precision, seed: 3 });
      const composed = make();
      const fused = make();
      const fusedly = await fusedStep(fused, fused.world.memory);
      for (let s = 0; s < 400; s++) {
        step(composed.world, composed.dt);
        fusedly();
      }
      expect(stateHash(fused.world)).toBe(stateHash(composed.world));
      const { x } = composed.world.previous.Position;
      expect(fused.world.previous.Position.x).toEqual(x);
    },
  );

  // Plain JavaScript rounds once a store, a kernel once an operation: in f64 the difference stays small for a while.
  test.each([
    ['particles', () => particles.create({ count: 500, dimensions, precision: 'f64' })],
    ['springs', () => springs.create({ count: 500, dimensions, precision: 'f64' })],
    ['nbody-direct', () => nbodyDirect.create({ count: 200, dimensions, precision: 'f64' })],
    ['attractors', () => attractors.create({ count: 500, dimensions, precision: 'f64' })],
  ] as const)('every peer of %s goes the same way', { timeout: 60_000 }, async (scene, create) => {
    const run: SceneRun = create();
    const made = await Promise.all(peersOf(scene).map((make) => make(run)));
    const peers = made.filter((peer) => peer !== undefined);
    expect(peers.length).toBeGreaterThan(0);
    for (let s = 0; s < 200; s++) {
      step(run.world, run.dt);
      for (const peer of peers) peer.step();
    }
    for (const peer of peers) for (const axis of ['x', 'y'] as const) expectSamePlaces(run, peer, axis);
  });
});

function expectSamePlaces({ world }: SceneRun, peer: Peer, axis: 'x' | 'y'): void {
  const theirs = Array.from(peer.positions(axis)).filter((x) => x !== 0);
  const ours = Array.from(world.components.Position[axis]).filter((x) => x !== 0);
  const sorted = (list: number[]) => Float64Array.from(list).sort();
  const [a, b] = [sorted(theirs), sorted(ours.slice(-theirs.length))];
  let worst = 0;
  for (let i = 0; i < a.length; i++) worst = Math.max(worst, Math.abs(a[i] - b[i]));
  expect(worst, peer.name).toBeLessThan(1e-6);
}
