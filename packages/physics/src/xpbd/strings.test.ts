// Chains of strings, springs of infinite stiffness that only pull: where they hang they are rods, where they are slack
// they are nothing.
import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { breakSprings, brokenSprings } from './breaking.ts';
import { xpbd } from './xpbd.ts';

/** A chain of `links` strings of 1 m with 1 kg each, g = 10 m/s²; it hangs from an anchor. */
function hang(links: number, { precision = 'f64' as 'f32' | 'f64', substeps = 1, breakForce = 0 } = {}) {
  const forces = [uniformGravity({ y: -10 }), springs()];
  const world = createPhysicsWorld({ capacity: 512, precision, integrator: xpbd({ substeps }), forces });
  let a = spawn(world, { position: {} });
  const bodies: number[] = [];
  for (let k = 1; k <= links; k++) {
    const b = spawn(world, { position: { y: -k }, velocity: {}, mass: 1 });
    spawn(world, { spring: { a, b, length: 1, stiffness: Infinity, tensionOnly: 1, breakForce } });
    bodies.push(b);
    a = b;
  }
  return { world, bodies };
}

describe('hanging strings', () => {
  test.each([
    [3, 1, 'f64', 1e-12],
    [10, 4, 'f64', 1e-12],
    [10, 1, 'f32', 1e-6],
    [200, 4, 'f64', 1e-12],
    // 200 m are rounded by 8 µm.
    [200, 1, 'f32', 2e-5],
  ] as const)('stay at rest: %i of them, with %i sub-steps, in %s', (links, substeps, precision, tolerance) => {
    const { world, bodies } = hang(links, { precision, substeps });
    for (let s = 0; s < 120; s++) step(world, 1 / 60);
    const { Position, Velocity } = world.components;
    for (const [k, b] of bodies.entries()) {
      expect(Math.abs(Velocity.y[b])).toBeLessThan(tolerance);
      expect(Math.abs(Position.y[b] + k + 1)).toBeLessThan(tolerance);
    }
  });

  test.each([
    [2, 1],
    [10, 1],
    [10, 4],
  ])('%i of them break at the weight that hangs below, with %i sub-steps', (links, substeps) => {
    const breaks = (breakForce: number) => {
      const { world } = hang(links, { substeps, breakForce });
      world.phases.finish.push(breakSprings);
      for (let s = 0; s < 90; s++) step(world, 1 / 60);
      return brokenSprings(world).total > 0;
    };
    expect(breaks(10 * links * (1 - 1e-9))).toBe(true);
    expect(breaks(10 * links * (1 + 1e-9))).toBe(false);
  });

  test('do not carry what was thrown up, and do not push it', () => {
    const { world, bodies } = hang(4);
    const { Position, Velocity } = world.components;
    const [, second, third, last] = bodies;
    // The last two fly up side by side with the same speed; they are back at their height after 0.4 s.
    Velocity.y[third] = Velocity.y[last] = 2;
    for (let s = 0; s < 20; s++) {
      step(world, 1 / 60);
      const flight = 2 - (10 * (s + 1)) / 60;
      expect(Velocity.y[third]).toBeCloseTo(flight, 12);
      expect(Velocity.y[last]).toBeCloseTo(flight, 12);
      expect(Math.abs(Velocity.y[second])).toBeLessThan(1e-12);
    }
    for (let s = 0; s < 40; s++) step(world, 1 / 60);
    // Strings do not bounce: all hang again.
    for (const [k, b] of bodies.entries()) {
      expect(Position.y[b]).toBeCloseTo(-k - 1, 10);
      expect(Velocity.y[b]).toBeCloseTo(0, 10);
    }
  });
});
