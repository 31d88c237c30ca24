// The plain loop does other work than ours, so it ends elsewhere. Bodies of a gas must diffuse as ours do, and bodies
// that fall must end in a heap.
import { step } from '@principia/physics';
import { type BoxedRun, circles, gas, type SceneRun } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { circlesJs } from './circles-js.ts';
import type { Peer } from './peer.ts';

const mean = (list: ArrayLike<number>) => Array.from(list).reduce((sum, value) => sum + value, 0) / list.length;

function runBoth(run: SceneRun, peer: Peer, steps: number): void {
  for (let i = 0; i < steps; i++) {
    step(run.world, run.dt);
    peer.step();
  }
}

function expectInBox(peer: Peer, { far }: BoxedRun): void {
  for (const axis of ['x', 'y', 'z'] as const) {
    const positions = Array.from(peer.positions(axis));
    expect(positions.every((value) => value >= 0 && value <= far[axis])).toBe(true);
  }
}

describe.each([2, 3] as const)('the plain loop over a grid, in %iD', (dimensions) => {
  const count = 1000;

  test('lets the bodies of a gas diffuse as ours do', () => {
    const run = gas.create({ count, dimensions, precision: 'f64' });
    const peer = circlesJs(run) as Peer;
    const ours = () => run.world.components.Position.x.slice(1, count + 1);
    const theirs = () => Float64Array.from(peer.positions('x'));
    const [ourStart, theirStart] = [ours(), theirs()];
    runBoth(run, peer, 120);
    const travel = (end: Float32Array | Float64Array, start: Float32Array | Float64Array) =>
      Math.sqrt(mean(Float64Array.from(end, (value, i) => (value - start[i]) ** 2)));
    const free = 2 * Math.sqrt(mean(run.world.components.Velocity.x.slice(1, count + 1).map((v) => v * v)));
    expect(travel(theirs(), theirStart) / travel(ours(), ourStart)).toBeGreaterThan(0.85);
    expect(travel(theirs(), theirStart) / travel(ours(), ourStart)).toBeLessThan(1.15);
    // Without collisions the distance would be speed times two seconds.
    expect(travel(theirs(), theirStart)).toBeLessThan(0.7 * free);
    expectInBox(peer, run as BoxedRun);
  });

  test('piles bodies up, less high than ours', { timeout: 60_000 }, () => {
    const run = circles.create({ count, dimensions, precision: 'f64' });
    const peer = circlesJs(run) as Peer;
    runBoth(run, peer, 480);
    const height = mean(run.world.components.Position.y.slice(1, count + 1));
    const ratio = mean(peer.positions('y')) / height;
    // Measured: 0.53 in 2D and 0.82 in 3D.
    expect(ratio).toBeGreaterThan(0.4);
    expect(ratio).toBeLessThan(1);
    expectInBox(peer, run as BoxedRun);
  });
});

test('it declines a run with friction, which it does not model', () => {
  expect(circlesJs(circles.create({ count: 10, friction: 0.5 }) as BoxedRun)).toBeUndefined();
});
