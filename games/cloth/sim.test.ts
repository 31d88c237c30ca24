import { bodies, momentum, restore, snapshot, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { blow } from './air-jet.ts';
import { settings } from './settings.ts';
import { applyValue, brokenThreads, CLOTH, createSim, cutAlong, threadCount } from './sim.ts';

const VALUES = { gravity: 9.81, wind: 0, strength: 2.5 };

/** Weight that hangs from the top of a column, N. */
const LOAD = (CLOTH.mass / CLOTH.columns) * (1 - 1 / CLOTH.rows) * VALUES.gravity;

function run(strength: number, steps = 60, more: Partial<typeof VALUES> = {}, dimensions: 2 | 3 = 2) {
  const sim = createSim({ values: { ...VALUES, strength, ...more }, seed: 1, dimensions });
  for (let i = 0; i < steps; i++) step(sim.world, sim.dt);
  return sim;
}

it('threads of twice the strength of their load survive its sudden weight, and weaker ones than the load break', () => {
  // Released suddenly, an elastic column stretches to at most twice its stretch at rest.
  expect(brokenThreads(run(2 * LOAD))).toBe(0);
  expect(brokenThreads(run(0.9 * LOAD))).toBeGreaterThanOrEqual(CLOTH.columns);
});

it('a torn cloth falls with the acceleration of gravity, reduced by air drag', () => {
  const { world } = run(0.5 * LOAD, 12);
  const mass = (CLOTH.mass * (CLOTH.rows - 1)) / CLOTH.rows;
  // Drag c v with c/m = k: v = g/k (1 - e^(-k t)). The cloth tears within the first steps.
  const k = CLOTH.drag;
  const [start, end] = [0.1, 0.2].map((time) => (VALUES.gravity / k) * (1 - Math.exp(-k * time)));
  const speed = -momentum(world).y / mass;
  expect(speed).toBeGreaterThan(start);
  expect(speed).toBeLessThanOrEqual(end);
});

it('applies changed settings while running, and rejects unknown ones', () => {
  const sim = run(2.5, 1);
  const { world, cloth } = sim;
  const values = { gravity: 0, wind: 5, strength: 0.5 * LOAD };
  for (const name of ['gravity', 'wind', 'strength']) expect(applyValue(sim, name, values)).toBe(true);
  expect(applyValue(sim, 'size', values)).toBe(false);
  for (let i = 0; i < 120; i++) step(world, sim.dt);
  // Weak threads break in the wind, and without gravity loose pieces drift with it.
  expect(brokenThreads(sim)).toBeGreaterThan(0);
  const hem = cloth.at(0, CLOTH.rows - 1);
  expect(world.components.Position.x[hem]).toBeGreaterThan(1);
});

it.each([2, 3] as const)('at the ends of the sliders it tears by its weight, in %iD', (dimensions) => {
  const { gravity, strength } = settings;
  expect(brokenThreads(run(strength.min, 60, { gravity: gravity.max }, dimensions))).toBeGreaterThan(CLOTH.columns);
});

it.each([2, 3] as const)(
  'holds in the breeze of the start, and stays a cloth in the strongest, in %iD',
  (dimensions) => {
    const { wind, strength } = settings;
    expect(brokenThreads(run(strength.initial, 300, { wind: wind.initial }, dimensions))).toBe(0);
    const { world } = run(strength.max, 300, { wind: wind.max }, dimensions);
    const { ids, count } = bodies(world);
    const columnsOf = (axis: 'x' | 'y' | 'z') =>
      Array.from(ids.subarray(0, count), (id) => world.components.Position[axis][id]);
    const spread = (axis: 'x' | 'y' | 'z') => Math.max(...columnsOf(axis)) - Math.min(...columnsOf(axis));
    // It hangs at least a third of its height below its edge, where the wind of 10 m/s once blew it to a line.
    expect(spread('y')).toBeGreaterThan((CLOTH.rows * CLOTH.spacing) / 3);
    expect(spread('x')).toBeLessThan(3 * CLOTH.columns * CLOTH.spacing);
  },
);

it('a swipe cuts the threads that it crosses, and a rewind joins them again', () => {
  const sim = run(50, 1);
  const { Position } = sim.world.components;
  const place = (node: number) => ({ x: Position.x[node], y: Position.y[node] });
  const before = threadCount(sim);
  const taken = snapshot(sim.world);
  // Across the middle, between two rows: one thread per column.
  const y = 0.5 * (Position.y[sim.cloth.at(0, 20)] + Position.y[sim.cloth.at(0, 21)]);
  expect(cutAlong(sim, place, { x: -5, y }, { x: 5, y: y + 1e-6 })).toBe(CLOTH.columns);
  expect(threadCount(sim)).toBe(before - CLOTH.columns);
  expect(cutAlong(sim, place, { x: -5, y: 5 }, { x: 5, y: 5 })).toBe(0);
  for (let i = 0; i < 60; i++) step(sim.world, sim.dt);
  expect(Position.y[sim.cloth.at(0, 30)]).toBeLessThan(-2);
  restore(sim.world, taken);
  expect(threadCount(sim)).toBe(before);
});

it('a jet of air pushes the cloth away where it blows, tears no thread, and leaves it alone when it stops', () => {
  const still = run(2.5, 0, {}, 3);
  const middle = still.cloth.at(32, 20);
  const { Position } = still.world.components;
  blow(still.world, 0, { through: { x: 0, y: 0, z: 5 }, along: { x: 0, y: 0, z: -1 } });
  for (let i = 0; i < 60; i++) step(still.world, still.dt);
  expect(Position.z[middle]).toBeLessThan(-0.2);
  expect(Math.abs(Position.z[still.cloth.at(0, 20)])).toBeLessThan(-0.3 * Position.z[middle]);
  expect(brokenThreads(still)).toBe(0);
  blow(still.world, 0, undefined);
  for (let i = 0; i < 600; i++) step(still.world, still.dt);
  expect(Math.abs(Position.z[middle])).toBeLessThan(0.05);
});

it('two jets blow at once, and one goes on when the other stops', () => {
  const { world, cloth, dt } = run(2.5, 0, {}, 3);
  const { Position } = world.components;
  const [left, right] = [cloth.at(12, 30), cloth.at(52, 30)];
  const along = { x: 0, y: 0, z: -1 };
  [left, right].forEach((node, jet) => {
    blow(world, jet, { through: { x: Position.x[node], y: Position.y[node], z: 5 }, along });
  });
  for (let i = 0; i < 60; i++) step(world, dt);
  expect(Position.z[left]).toBeLessThan(-0.2);
  expect(Position.z[right]).toBeLessThan(-0.2);
  blow(world, 1, undefined);
  for (let i = 0; i < 600; i++) step(world, dt);
  expect(Position.z[left]).toBeLessThan(-0.2);
  expect(Math.abs(Position.z[right])).toBeLessThan(0.1);
});

it('in 2D a jet of air drives the cloth apart from where it blows', () => {
  const { world, cloth, dt } = run(2.5, 0);
  const { Position } = world.components;
  const [left, right] = [cloth.at(20, 36), cloth.at(44, 36)];
  const before = Position.x[right] - Position.x[left];
  blow(world, 0, { through: { x: 0, y: -0.8, z: 0 }, along: { x: 0, y: 0, z: 0 } });
  for (let i = 0; i < 30; i++) step(world, dt);
  expect(Position.x[right] - Position.x[left]).toBeGreaterThan(before + 0.02);
});
