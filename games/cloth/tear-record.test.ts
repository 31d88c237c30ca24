import { restore, snapshot, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { createSim, cutAlong, threadCount } from './sim.ts';
import { MAX_FRAMES } from './tear-record.ts';

const make = () => createSim({ values: { gravity: 9.81, wind: 0, strength: 50 }, seed: 1, dimensions: 2 });
type Sim = ReturnType<typeof make>;

function run({ world, dt }: Sim, steps: number) {
  for (let i = 0; i < steps; i++) step(world, dt);
}

/** Cuts all columns at half height. */
function cut(sim: Sim): number {
  const { x, y } = sim.world.components.Position;
  return cutAlong(sim, (node) => ({ x: x[node], y: y[node] }), { x: -3, y: 0.01 }, { x: 3, y: 0.012 });
}

it('knows where each node was, and between two frames is off by their curvature only', () => {
  const sim = make();
  run(sim, 20);
  const { x, y } = sim.world.components.Position;
  const places: number[][] = [];
  for (let i = 0; i < 12; i++) {
    step(sim.world, sim.dt);
    const node = sim.cloth.at(30, 30);
    places.push([sim.world.tick - 1, x[node], y[node]]);
  }
  const pose = new Float32Array(3 * sim.tears.nodeCount);
  for (const [tick, px, py] of places.slice(0, -1)) {
    expect(sim.tears.positionsAt(tick, pose)).toBe(true);
    const index = 3 * (30 * sim.cloth.columns + 30);
    // Halfway between frames 1/30 s apart a line is off by a (1/30)²/8, with an acceleration of a few g.
    const tolerance = tick % 2 === 0 ? 1e-7 : (30 / 900) * (1 / 8);
    expect(Math.abs(pose[index] - px)).toBeLessThanOrEqual(tolerance);
    expect(Math.abs(pose[index + 1] - py)).toBeLessThanOrEqual(tolerance);
  }
  expect(sim.tears.positionsAt(sim.world.tick + 10, pose)).toBe(false);
});

it('has a tear once it is over, until the record has forgotten it', () => {
  const sim = make();
  run(sim, 40);
  const before = threadCount(sim);
  const count = cut(sim);
  expect(count).toBeGreaterThan(50);
  run(sim, 10);
  expect(sim.tears.endedCount).toBe(count);
  expect(sim.tears.tear).toBeUndefined();
  run(sim, 40);
  const tear = sim.tears.tear;
  expect(tear).toEqual({ from: 16, to: 85 });
  expect(sim.tears.threadsAt(39)).toBe(before);
  expect(sim.tears.threadsAt(85)).toBe(before - count);
  run(sim, 2 * MAX_FRAMES);
  expect(sim.tears.tear).toBeUndefined();
});

it('forgets what a rewind has undone', () => {
  const sim = make();
  run(sim, 40);
  const taken = snapshot(sim.world);
  const before = threadCount(sim);
  cut(sim);
  run(sim, 60);
  expect(sim.tears.tear).toBeDefined();
  restore(sim.world, taken);
  run(sim, 60);
  expect(sim.tears.tear).toBeUndefined();
  expect(sim.tears.threadsAt(sim.world.tick)).toBe(before);
});

it('keeps a tear while it is watched, and does not offer it again', () => {
  const sim = make();
  run(sim, 40);
  cut(sim);
  run(sim, 60);
  sim.tears.isFrozen = true;
  run(sim, 2 * MAX_FRAMES);
  expect(sim.tears.positionsAt(30, new Float32Array(3 * sim.tears.nodeCount))).toBe(true);
  sim.tears.isFrozen = false;
  run(sim, 60);
  expect(sim.tears.tear).toBeUndefined();
});
