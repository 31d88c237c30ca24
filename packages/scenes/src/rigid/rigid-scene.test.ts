/** Which integrators scenes of rigid bodies take. */
import { energy, rungeKutta4, softStep, step, velocityVerlet } from '@principia/physics';
import { expect, test } from 'vitest';
import { SCENES } from '../index.ts';
import { elasticDiscs } from './elastic-discs.ts';
import { pyramid } from './pyramid.ts';

const rigid = SCENES.filter((scene) => scene.create({}).world.integrator.name === softStep().name);

test('all of them use the soft step that they are given', () => {
  expect(rigid).toContain(pyramid);
  for (const scene of rigid) {
    const integrator = softStep({ substeps: 8 });
    expect(scene.create({ integrator }).world.integrator).toBe(integrator);
  }
});

test('impacts of all speeds bounce in a room where the threshold is low, and keep the energy', () => {
  const keptWith = (options: Parameters<typeof elasticDiscs.create>[0]) => {
    const { world, dt } = elasticDiscs.create({ count: 100, ...options });
    const before = energy(world).total;
    for (let i = 0; i < 10 / dt; i++) step(world, dt);
    return energy(world).total / before;
  };
  const lost = 1 - keptWith({});
  // An impact below the threshold of 1 m/s loses energy in proportion to its square: at 0.01 m/s next to nothing.
  expect(1 - keptWith({ integrator: softStep({ restitutionThreshold: 0.01 }) })).toBeLessThan(0.1 * lost);
});

test('others are refused', () => {
  expect(() => pyramid.create({ integrator: rungeKutta4 })).toThrow(
    /E_RANGE: rigid bodies are not solved by Runge-Kutta/,
  );
  expect(() => pyramid.create({ integrator: velocityVerlet })).toThrow(/E_RANGE: this preset does not work with/);
});
