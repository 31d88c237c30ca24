import { contacts, step } from '@principia/physics';
import { type BoxedRun, circles, gas, type SceneRun } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { circlesJs } from './circles-js.ts';
import type { Peer } from './peer.ts';

/** Steps both, and returns how many contacts there were. */
function runBoth(run: SceneRun, peer: Peer, steps: number): number {
  let met = 0;
  for (let i = 0; i < steps; i++) {
    step(run.world, run.dt);
    peer.step();
    met += contacts(run.world).count;
  }
  return met;
}

function expectSameBits({ world }: SceneRun, peer: Peer, count: number): void {
  for (const axis of ['x', 'y', 'z'] as const) {
    const ours = Array.from(world.components.Position[axis].subarray(1, count + 1));
    expect(Array.from(peer.positions(axis)), axis).toEqual(ours);
  }
}

describe.each([2, 3] as const)('plain JavaScript ends in the same bits in f64, in %iD', (dimensions) => {
  test.each([5, 40, 200])('a gas at %d m/s', (speed) => {
    const count = dimensions === 2 ? 2000 : 1000;
    const run = gas.create({ count, dimensions, precision: 'f64', fraction: 0.5, speed });
    const peer = circlesJs(run) as Peer;
    expect(runBoth(run, peer, 200)).toBeGreaterThan(10_000);
    expectSameBits(run, peer, count);
  });

  // Three hundred steps are 2.5 s: bodies fall, pile up, lie on the floor and on each other.
  test('bodies that fall into a heap', { timeout: 60_000 }, () => {
    const run = circles.create({ count: 600, dimensions, precision: 'f64' });
    const peer = circlesJs(run) as Peer;
    expect(runBoth(run, peer, 300)).toBeGreaterThan(50_000);
    expectSameBits(run, peer, 600);
  });
});

test('it does not pretend to do the work of a run with friction', () => {
  expect(circlesJs(circles.create({ count: 10, friction: 0.5 }) as BoxedRun)).toBeUndefined();
});
