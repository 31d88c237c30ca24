import { describe, expect, test } from 'vitest';
import { emitting, living, run } from '../../../../test/support/emitting.ts';
import { spawn } from '../bodies/spawn.ts';
import { linearDrag } from '../forces/drag.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { defineForce } from '../laws/force.ts';
import type { PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { EmitterOptions } from './options.ts';

const G = 10;
const gravity = uniformGravity({ y: -G });
const jet: Partial<EmitterOptions> = { rate: 64, lifetime: 10, speed: 12, spread: 0, mass: 0.5 };

/** Heights at `time` of the particles that were born by then, 1/64 s apart, the oldest first. */
function heights(options: Partial<EmitterOptions>, world: PhysicsWorldOptions, dt: number, time = 0.5): number[] {
  const made = emitting(options, { integrator: velocityVerlet, ...world });
  run(made.world, time, dt);
  step(made.world, 1e-12);
  const { y } = made.world.components.Position;
  return living(made.emitter)
    .map((eid) => y[eid])
    .slice(0, Math.round(64 * time) - 1);
}

describe('a particle that is born within a step', () => {
  test.each(['f32', 'f64'] as const)('falls from its birth on: the jet is the parabola, %s', (precision) => {
    // Constant acceleration is exact in velocity Verlet and for the rest of the step of birth, so only rounding remains.
    for (const dt of [1 / 10, 1 / 64, 1 / 50]) {
      const y = heights(jet, { precision, forces: [gravity] }, dt);
      expect(y.length).toBeGreaterThan(25);
      y.forEach((height, i) => {
        const age = 0.5 - (i + 1) / 64;
        expect(height).toBeCloseTo(12 * age - (G * age * age) / 2, precision === 'f32' ? 4 : 9);
      });
    }
  });

  test('rises to v²/2g, and no further', () => {
    const made = emitting({ ...jet, rate: 37 }, { integrator: velocityVerlet, forces: [gravity] });
    let apex = 0;
    for (let i = 0; i < 40; i++) {
      step(made.world, 1 / 10);
      for (const eid of living(made.emitter)) apex = Math.max(apex, made.world.components.Position.y[eid]);
    }
    expect(apex).toBeLessThan((12 * 12) / (2 * G) + 1e-9);
    expect(apex).toBeGreaterThan((12 * 12) / (2 * G) - (G * (1 / 37) ** 2) / 2);
  });

  test('converges with the square of the step under drag', () => {
    const forces = [gravity, linearDrag()];
    // y = (v + g/γ)(1 − e^−γt)/γ − g t/γ with γ = k/m.
    const gamma = 3;
    const exact = (age: number) => ((12 + G / gamma) * (1 - Math.exp(-gamma * age))) / gamma - (G * age) / gamma;
    const largestError = (dt: number) =>
      Math.max(
        ...heights({ ...jet, linearDrag: gamma * 0.5 }, { forces }, dt).map((y, i) =>
          Math.abs(y - exact(0.5 - (i + 1) / 64)),
        ),
      );
    const [coarse, fine, finest] = [1 / 10, 1 / 20, 1 / 40].map(largestError);
    expect(Math.log2(coarse / fine)).toBeGreaterThan(1.7);
    expect(Math.log2(fine / finest)).toBeGreaterThan(1.7);
    expect(finest).toBeLessThan(0.01);
  });

  test('feels a function of its own, of one body, as it feels a law', () => {
    const ownGravity = defineForce({
      name: 'own gravity',
      local: true,
      accumulate({ scratch: { force }, components: { Mass } }, first, last) {
        for (let row = first; row < last; row++) force.y[row] -= G * Mass.value[row];
      },
    });
    const law = heights(jet, { forces: [gravity] }, 1 / 10);
    const own = heights(jet, { forces: [ownGravity] }, 1 / 10);
    own.forEach((y, i) => {
      expect(y).toBeCloseTo(law[i], 12);
    });
  });

  test('gets nothing of a force that is not finite, which the step reports', () => {
    const bad = defineForce({
      name: 'bad',
      local: true,
      accumulate({ scratch: { force } }, first, last) {
        for (let row = first; row < last; row++) force.x[row] = Number.NaN;
      },
    });
    const { world, emitter } = emitting(jet, { forces: [bad] });
    run(world, 0.2, 0.05);
    for (const eid of emitter.ids) expect(Number.isFinite(world.components.Position.x[eid])).toBe(true);
    expect(world.faults.faults.length).toBeGreaterThan(0);
  });

  test('does not move again what a burst made, or other bodies', () => {
    const { world, emitter } = emitting({ ...jet, rate: 1000 }, { integrator: velocityVerlet, forces: [gravity] });
    const ball = spawn(world, { position: {}, velocity: { y: 5 }, mass: 1 });
    run(world, 0.5, 1 / 16);
    expect(living(emitter).length).toBeGreaterThan(400);
    expect(world.components.Position.y[ball]).toBeCloseTo(5 * 0.5 - (G * 0.25) / 2, 12);
  });

  test('also where the rows of a pool are given in any order', () => {
    const scattered = { ...jet, rate: 2000, lifetime: [0.05, 0.3] as const, capacity: 900 };
    const { world, emitter } = emitting(scattered, { integrator: velocityVerlet, forces: [gravity] });
    run(world, 3, 1 / 30);
    const { y } = world.components.Position;
    const speed = world.components.Velocity.y;
    // Energy tells height from speed, whatever the age: v²/2 + g y = 72.
    for (const eid of living(emitter)) expect((speed[eid] * speed[eid]) / 2 + G * y[eid]).toBeCloseTo(72, 9);
  });
});
