import { momentum, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { applyValue, brokenThreads, CLOTH, createSim } from './sim.ts';

const VALUES = { gravity: 9.81, wind: 0, strength: 2.5 };

/** Weight that hangs from the top of a column, N. */
const LOAD = (CLOTH.mass / CLOTH.columns) * (1 - 1 / CLOTH.rows) * VALUES.gravity;

function run(strength: number, steps = 60) {
  const sim = createSim({ values: { ...VALUES, strength }, seed: 1 });
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
  // Drag c v with c/m = 4 /s: v = g/4 (1 - e^(-4 t)). The cloth tears within the first steps.
  const [start, end] = [0.1, 0.2].map((time) => (VALUES.gravity / 4) * (1 - Math.exp(-4 * time)));
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
