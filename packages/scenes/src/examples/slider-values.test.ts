/** Figures are right for other values of the sliders, too: those at which steps, or the end of the run, are felt most. */
import { step } from '@principia/physics';
import { expect, it } from 'vitest';
import { EXAMPLES } from './examples.gen.ts';

it.each([
  ['ch03-move-circle-parametric', { rate: 2.733, width: 1.6946, height: 0.209 }],
  ['ch06-rocket', { exhaust: 268, fuel: 1.3235, gravity: 0 }],
  ['ch07-airplane', { push: 9.05, wing: 0.0566 }],
  ['ch07-lift', { wing: 1, speed: 20, mass: 0.5 }],
  ['ch07-parachute', { opening: 20.07 }],
  ['ch08-damped', { stiffness: 40, damping: 0 }],
  ['ch11-1d-elastic', { u1: 'min', u2: 'max' }],
  ['ch11-1d-inelastic', { u1: 'min', u2: 'max' }],
  ['ch13-bouncing-block', { restitution: 0.00479, inertia: 6.89 }],
] as const)('%s at %j', async (id, values) => {
  const example = await EXAMPLES.find((entry) => entry.id === id)?.load();
  if (example === undefined) throw new Error(`There is no example ${id}.`);
  const numbers = Object.entries<number | 'min' | 'max'>(values).map(([name, value]) => {
    return [name, typeof value === 'number' ? value : example.parameters[name][value]];
  });
  const run = example.start({ values: Object.fromEntries(numbers) });
  for (let i = 0; i <= example.duration / run.dt && !run.isDone(); i++) {
    step(run.world, run.dt);
    run.observe();
  }
  const states = run.checkStates();
  const labels = example.checks.map(({ label }) => label);
  expect(states.some(({ state }) => state === 'passed')).toBe(true);
  expect(labels.filter((_, i) => states[i].state === 'failed')).toEqual([]);
});
