/** The engines build the scene they are given: their bodies stay where ours do, though each takes a way of its own. */
import { step } from '@principia/physics';
import { findScene, type SceneRun } from '@principia/scenes';
import { describe, expect, it } from 'vitest';
import { peersOf } from '../all.ts';
import type { Peer } from '../peer.ts';
import { readRigidScene } from './rigid-scene.ts';

const STEPS = 120;
/** A parameter of all these scenes. */
const AWAKE: object = { sleeping: 0 };

/** The root mean square of the distances from the middle of all, m: a single box that is squeezed out must not decide. */
function extentOf(positions: readonly ArrayLike<number>[]): number {
  const [xs, ys] = positions.map((values) => Array.from(values));
  const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [x, y] = [mean(xs), mean(ys)];
  return Math.sqrt(mean(xs.map((value, i) => (value - x) ** 2 + (ys[i] - y) ** 2)));
}

const extentOfPeer = (peer: Peer) => extentOf([peer.positions('x'), peer.positions('y')]);

function extentOfOurs(run: SceneRun): number {
  const bodies = readRigidScene(run)?.bodies ?? [];
  return extentOf([bodies.map(({ x }) => x), bodies.map(({ y }) => y)]);
}

describe.each([
  ['pyramid', 55],
  ['many-pyramids', 110],
  ['discs', 300],
  ['smash', 200],
  ['elastic-discs', 200],
  ['tumbler', 200],
  ['washer', 300],
  ['chains', 100],
  ['joint-grid', 100],
])('%s', (name, count) => {
  it('has the same extent in every engine', async () => {
    const run = findScene(name)?.create({ count, ...AWAKE }) as SceneRun;
    for (let s = 0; s < 10; s++) step(run.world, run.dt);
    const peers = (await Promise.all(peersOf(name).map((make) => make(run)))).filter((peer) => peer !== undefined);
    expect(peers.length).toBe(4);
    for (const peer of peers) expect(Math.abs(extentOfPeer(peer) / extentOfOurs(run) - 1)).toBeLessThan(1e-6);
    for (let s = 0; s < STEPS; s++) step(run.world, run.dt);
    for (const peer of peers) {
      for (let s = 0; s < STEPS; s++) peer.step();
      const ratio = extentOfPeer(peer) / extentOfOurs(run);
      // What is squeezed out of the wall that is smashed flies on for two seconds: how fast it does differs most.
      expect(ratio, peer.name).toBeGreaterThan(name === 'smash' ? 0.6 : 0.7);
      // The chains of planck stretch to twice their length under the heavy ball.
      expect(ratio, peer.name).toBeLessThan(name === 'chains' && peer.name.startsWith('planck') ? 2.5 : 1.4);
    }
  });
});
