import { contacts, step } from '@principia/physics';
import { gas } from '@principia/scenes';
import { expect, test } from 'vitest';
import { circlesJs } from './circles-js';

test.each([5, 40, 200])('plain JavaScript does the same work on a gas at %d m/s: the same bits in f64', (speed) => {
  const run = gas.create({ count: 2000, precision: 'f64', fraction: 0.5, speed });
  const peer = circlesJs(run);
  let met = 0;
  for (let i = 0; i < 200; i++) {
    step(run.world, run.dt);
    peer.step();
    met += contacts(run.world).count;
  }
  expect(met).toBeGreaterThan(10_000);
  for (const axis of ['x', 'y'] as const) {
    expect(Array.from(peer.positions(axis))).toEqual(Array.from(run.world.components.Position[axis].subarray(1, 2001)));
  }
});
