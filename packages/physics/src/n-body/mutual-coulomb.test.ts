import { expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { energy, momentum } from '../diagnostics/energy.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { mutualCoulomb } from './mutual-coulomb.ts';

function pair(charges: [number, number], k: number, distance: number) {
  const world = createPhysicsWorld({ forces: [mutualCoulomb({ k })] });
  spawn(world, { position: { x: -distance / 2 }, velocity: {}, mass: 1, charge: charges[0] });
  spawn(world, { position: { x: distance / 2 }, velocity: {}, mass: 1, charge: charges[1] });
  return world;
}

test('like charges separate at the relative speed √(2 k q²/(μ d)), with zero momentum', () => {
  const world = pair([1, 1], 1e4, 100);
  const before = energy(world).total;
  for (let i = 0; i < 20_000; i++) step(world, 0.01);
  const { x } = world.components.Velocity;
  // At 200 s they are 3900 m apart; by energy, 1.3 % of the speed is still to be gained.
  const left = 1e4 / Math.abs((world.components.Position.x[2] as number) * 2);
  const speed = Math.sqrt(((x[2] as number) - (x[1] as number)) ** 2 + 4 * left);
  expect(speed).toBeCloseTo(20, 3);
  expect(Math.abs(momentum(world).x)).toBeLessThan(1e-12);
  expect(Math.abs(energy(world).total / before - 1)).toBeLessThan(1e-6);
});

test('opposite charges at rest meet after (π/2) √(μ d³/(2k))', () => {
  const world = pair([1, -1], 1e4, 100);
  const [mu, d] = [0.5, 100];
  const collapse = (Math.PI / 2) * Math.sqrt((mu * d ** 3) / (2 * 1e4));
  let gap = d;
  while (gap > 0.02 * d && world.time < 2 * collapse) {
    step(world, 2e-4);
    const { x } = world.components.Position;
    gap = (x[2] as number) - (x[1] as number);
  }
  // Free fall from rest: t(s), with s the remaining fraction of the distance.
  const share = gap / d;
  const done = (2 / Math.PI) * (Math.acos(Math.sqrt(share)) + Math.sqrt(share * (1 - share)));
  expect(world.time / (collapse * done)).toBeCloseTo(1, 3);
  expect(Math.abs(momentum(world).x)).toBeLessThan(1e-11);
});

test('a charge without mass exerts forces and stays fixed, an uncharged mass feels no force', () => {
  const world = createPhysicsWorld({ forces: [mutualCoulomb({ k: 1 })] });
  spawn(world, { position: { x: 0 }, velocity: {}, charge: 2 });
  spawn(world, { position: { x: 1 }, velocity: {}, mass: 1, charge: 1 });
  spawn(world, { position: { y: 1 }, velocity: {}, mass: 1 });
  step(world, 1e-3);
  const { x, y } = world.components.Velocity;
  expect([x[1], y[1], x[3], y[3]]).toEqual([0, 0, 0, 0]);
  expect(x[2]).toBeCloseTo(2e-3, 7);
});
