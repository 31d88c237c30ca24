import { expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { angularMomentum, energy } from '../diagnostics/energy.ts';
import { springs } from '../forces/springs.ts';
import { createCloth } from '../soft-bodies/cloth.ts';
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

// Corrections act along the springs as they will be, so that a turn by ωh takes ω²h² of the angular momentum, and 1/ω² grows by 2h a second.
test.each([0, 500])('what turns freely is slowed down by ω³ h, with a shear of %d N/m', (shear) => {
  const world = createPhysicsWorld({ integrator: xpbd({ substeps: 5, iterations: 1 }), forces: [springs()] });
  const sheet = {
    corner: { x: -0.2, y: 0.2 },
    columns: 5,
    rows: 5,
    spacing: 0.1,
    mass: 1,
    shear,
    pins: 'none',
  } as const;
  const { nodes } = createCloth(world, sheet);
  const { Position, Velocity } = world.components;
  const [spin, h, time] = [5, 1 / 300, 5];
  for (const node of nodes) {
    Velocity.x[node] = -spin * Position.y[node];
    Velocity.y[node] = spin * Position.x[node];
  }
  const start = angularMomentum(world).z;
  for (let s = 0; s < time * 60; s++) step(world, 1 / 60);
  const expected = 1 / Math.sqrt(1 + 2 * spin * spin * h * time);
  // What is left out is of the order of ω²h², 3e-4.
  expect(Math.abs(angularMomentum(world).z / start / expected - 1)).toBeLessThan((spin * h) ** 2);
});
