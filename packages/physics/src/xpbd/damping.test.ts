import { expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { energy } from '../diagnostics/energy.ts';
import { springs } from '../forces/springs.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { xpbd } from './xpbd.ts';

test.each([
  [1, 1],
  [10, 4],
  [400, 1],
])(
  'implicit Euler divides the energy by 1 + ω²h² per sub-step, at ω² = %d 1/s² with %i sub-steps',
  (stiffness, substeps) => {
    const world = createPhysicsWorld({ capacity: 20, integrator: xpbd({ substeps }), forces: [springs()] });
    const a = spawn(world, { position: {} });
    const b = spawn(world, { position: { x: 1.1 }, velocity: {}, mass: 1 });
    spawn(world, { spring: { a, b, length: 1, stiffness } });
    const start = energy(world).total;
    let expected = 1;
    for (let s = 0; s < 60; s++) {
      step(world, 1 / 60);
      for (let k = 0; k < substeps; k++) expected /= 1 + stiffness / (60 * substeps) / (60 * substeps);
    }
    // The extension is rounded at 1e-16 of 1 m, beside 0.1 m times the root of what is left, in 240 sub-steps at most.
    const rounding = (240 * 1e-16) / (0.1 * Math.sqrt(expected));
    expect(Math.abs(energy(world).total / start / expected - 1)).toBeLessThan(10 * rounding);
  },
);
