// Sums of forces, projectiles with drag, and floating. y points down.
import {
  linearDrag,
  positionFirstEuler,
  quadraticDrag,
  rungeKutta4,
  step,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { expect, test } from 'vitest';
import ballInWater from '../../packages/scenes/src/examples/ch05/floating-ball.ts';
import projectileDrag from '../../packages/scenes/src/examples/ch05/projectile-drag.ts';
import ballInShallowWater from '../../packages/scenes/src/examples/ch07/floating-ball.ts';
import { forceOn, run, single, started } from '../support/laws.ts';
import { crossings } from '../support/orbits.ts';

test('ch05-forces-object: the forces of a world add, axis by axis', () => {
  const body = { velocity: { x: 3, y: -4 }, mass: 2, linearDrag: 0.5, quadraticDrag: 0.1 };
  const laws = [uniformGravity({ x: 1, y: 10 }), linearDrag(), quadraticDrag({ x: 1 })];
  const each = laws.map((law) => single([law], body)).map(({ world, eid }) => forceOn(world, eid));
  const all = single(laws, body);
  const sum = forceOn(all.world, all.eid);
  // Forces and accelerations are summed apart: every sum and product is rounded, by 2⁻⁵³ of some 20 N, a few times.
  expect(Math.abs(sum.x - each.reduce((total, { x }) => total + x, 0))).toBeLessThan(1e-14);
  expect(Math.abs(sum.y - each.reduce((total, { y }) => total + y, 0))).toBeLessThan(1e-14);
});

test('ch05-projectile-drag: apex at 4.700 s, and position after 10 s', () => {
  for (const integrator of [velocityVerlet, rungeKutta4]) {
    const { world, at, going } = started(projectileDrag, { integrator });
    let apex = { time: 0, y: 400 };
    for (let i = 0; i < 600; i++) {
      const before = going().y;
      step(world, 1 / 60);
      if (before < 0 && going().y >= 0) apex = { time: world.time - going().y / 10, y: at().y };
    }
    // Upwards v = (g + k v₀/m) e^(-kt/m) - g in units of m/k: it turns after ten times the logarithm of 1.6.
    expect(Math.abs(apex.time - 10 * Math.log(1.6))).toBeLessThan(1e-3);
    expect(apex.time).toBeCloseTo(4.7, 3);
    expect(Math.abs(apex.y - 270)).toBeLessThan(0.01);
    expect(Math.abs(at().x - 429.27)).toBeLessThan(0.01);
    expect(Math.abs(at().y - 388.61)).toBeLessThan(0.01);
  }
});

test('ch05-projectile-drag: result of the first-order scheme at 60 steps per second', () => {
  const { world, at } = started(projectileDrag, { integrator: positionFirstEuler });
  run(world, 10);
  expect(at().x).toBeCloseTo(429.46, 2);
  expect(at().y).toBeCloseTo(388.12, 2);
});

/** Id of the second ball in the water, which bobs without drag. */
const BOB = 2;

test.each([
  ['ch05-floating-ball: rest, bob and plunge', ballInWater, 309.043, 5.439, 416.8],
  ['ch07-floating-ball: rest, bob and plunge in shallow units', ballInShallowWater, 104.521, 8.6, 153.0],
] as const)('%s', (_, example, rest, period, deepest) => {
  // At rest the force is zero: the figure is rounded by 5e-4, which the bob's own stiffness ω² pushes back.
  const resting = started(example, {}, BOB);
  resting.world.components.Position.y[BOB] = rest;
  const stiffness = ((2 * Math.PI) / period) ** 2;
  expect(Math.abs(forceOn(resting.world, resting.eid).y)).toBeLessThan(5e-4 * stiffness);
  // A small bob: the figure is rounded by 5e-4, and 2 % of the radius lengthens the period by some 0.02²/8 of it.
  const bob = started(example, {}, BOB);
  expect(bob.at().y - rest).toBeCloseTo(0.02 * bob.world.components.Collider.radius[BOB], 3);
  const [first, second] = crossings(bob.world, () => bob.at().y, rest, 3 * period, 1 / 240);
  expect(Math.abs(second - first - period)).toBeLessThan(5e-4 + (0.02 ** 2 / 8) * period);
  // The first plunge of the thrown ball: to the digits of the figure by the scheme that it was measured with, and
  // within the half a per cent that it may be off by an accurate one.
  for (const [integrator, tolerance] of [
    [positionFirstEuler, 0.05],
    [velocityVerlet, 0.005 * deepest],
  ] as const) {
    const thrown = started(example, { integrator });
    let depth = 0;
    run(thrown.world, 20, 1 / 60, () => {
      depth = Math.max(depth, thrown.at().y);
    });
    expect(Math.abs(depth - deepest), integrator.name).toBeLessThan(tolerance);
  }
});

test('ch07-floating-ball: quadratic drag damps the oscillation as 1/t, so that it persists after 60 s', () => {
  const { world, eid, at, going } = started(ballInShallowWater, { integrator: rungeKutta4 });
  const { Velocity } = world.components;
  [Velocity.x[eid], Velocity.y[eid]] = [0, 0];
  const turns: { time: number; amplitude: number }[] = [];
  let before = going().y;
  run(world, 120, 1 / 60, () => {
    const now = going().y;
    if (before > 0 && now <= 0) turns.push({ time: world.time, amplitude: at().y - 104.521 });
    before = now;
  });
  const late = turns.filter(({ time }) => time > 75);
  const [first, last] = [late[0], late[late.length - 1]];
  // The mean power of the drag, f k ω³ A³ 4/3π, against the energy m ω² A²/2: 1/A grows by 4 f k ω/3π m each second.
  const growth = ((2 / 3) * 0.01 * ((2 * Math.PI) / 8.6) * 4) / (3 * Math.PI);
  const measured = (1 / last.amplitude - 1 / first.amplitude) / (last.time - first.time);
  // A bob of A = 6 in a radius of 20 is harmonic to (A/r)²/8 = 1 %.
  expect(Math.abs(measured / growth - 1)).toBeLessThan(0.01);
});
