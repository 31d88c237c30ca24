import { describe, expect, test } from 'vitest';
import { forceOn } from '../../../../test/support/laws.ts';
import { spawn } from '../bodies/spawn.ts';
import { angularMomentum, energy } from '../diagnostics/energy.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { semiImplicitEuler } from '../integrators/semi-implicit-euler.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { defineForce } from '../laws/force.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { Integrator } from '../world/types.ts';
import { attractors } from './attractors.ts';
import { paczynskiWiita } from './paczynski-wiita.ts';

/** The scene ch06-orbits: a sun of μ = 1e6 at (275, 200), a planet at (200, 50). */
function orbit(velocity: { x: number; y: number }, options: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 10, forces: [attractors()], ...options });
  spawn(world, { position: { x: 275, y: 200 }, attractor: 1e6 });
  const planet = spawn(world, { position: { x: 200, y: 50 }, velocity, mass: 1 });
  return { world, planet };
}

const SUN = { x: 275, y: 200 };

describe('attractors', () => {
  test('are at the position of the evaluation time that a custom scheme asks for', () => {
    let moment = 0;
    const probe: Integrator = {
      name: 'probe',
      order: 1,
      symplectic: false,
      evaluations: 1,
      advance: (world, ranges, _dt, evaluateForces) => evaluateForces(world, ranges, world.time + moment),
    };
    const world = createPhysicsWorld({ capacity: 10, forces: [attractors()], integrator: probe });
    spawn(world, { position: {}, velocity: { x: 3 }, attractor: 1e3 });
    const body = spawn(world, { position: { x: 10 }, mass: 1 });
    for (moment of [0.5, 0, 1]) {
      step(world, 1);
      // The expected value is μ / r², with r = 3 m/s times the time; products and quotient are rounded a few times.
      expect(world.scratch.force.x[body]).toBeCloseTo(-1e3 / (10 - 3 * moment) ** 2, 12);
    }
  });

  test('ch06-orbits: angular momentum exact, energy within its bound for each integrator', () => {
    // Measured over 1000 s, to half a unit of the last digit.
    for (const [integrator, bound] of [
      [semiImplicitEuler, 2.35e-3],
      [velocityVerlet, 1.35e-5],
      [rungeKutta4, 1.65e-10],
    ] as const) {
      const { world } = orbit({ x: 80, y: -40 }, { integrator });
      const start = energy(world).total;
      expect(angularMomentum(world, SUN).z).toBeCloseTo(15000, 9);
      let worst = 0;
      for (let i = 0; i < 60 * 200; i++) {
        step(world, 1 / 60);
        worst = Math.max(worst, Math.abs(energy(world).total / start - 1));
      }
      expect(worst, integrator.name).toBeLessThan(bound);
      const drift = Math.abs(angularMomentum(world, SUN).z / 15000 - 1);
      expect(drift).toBeLessThan(integrator === rungeKutta4 ? 1e-9 : 1e-12);
    }
  });

  test('follow the inverse square law and Plummer softening', () => {
    const force = (distance: number, softening: number) => {
      const world = createPhysicsWorld({ dimensions: 3, capacity: 10, forces: [attractors()] });
      spawn(world, { position: {}, attractor: { mu: 12, softening } });
      const body = spawn(world, { position: { z: distance }, velocity: {}, mass: 2 });
      return forceOn(world, body).z;
    };
    expect(force(2, 0)).toBe(-6);
    expect(force(4, 0)).toBe(-1.5);
    expect(force(4, 3)).toBeCloseTo((-2 * 12 * 4) / 125, 14);
    expect(force(0, 0)).toBe(0);
    expect(force(0, 3)).toBe(0);
  });

  test('exert no force on themselves, with or without softening', () => {
    for (const precision of ['f32', 'f64'] as const) {
      for (let before = 0; before < 5; before++) {
        const world = createPhysicsWorld({ capacity: 10, precision, forces: [attractors()] });
        for (let i = 0; i < before; i++) spawn(world, { position: { x: 1e6 } });
        const centre = spawn(world, { position: { x: 1 }, velocity: { x: 1, y: 2 }, mass: 3, attractor: 1e9 });
        for (let i = 0; i < 10; i++) step(world, 0.1);
        expect(world.components.Velocity.x[centre]).toBe(1);
        expect(world.components.Velocity.y[centre]).toBe(2);
      }
    }
  });

  test('moving centres give the same result in chunks and over the whole range', () => {
    const run = (local: boolean) => {
      const world = createPhysicsWorld({ capacity: 6000, forces: [attractors()] });
      if (!local) world.forces.push(defineForce({ name: 'nothing', local: false, accumulate: () => {} }));
      const centre = spawn(world, { position: {}, velocity: { x: 3 }, attractor: { mu: 5, softening: 0.1 } });
      for (let i = 0; i < 5000; i++) spawn(world, { position: { x: i / 100, y: 1 }, velocity: {}, mass: 1 });
      for (let i = 0; i < 5; i++) step(world, 0.01);
      expect(world.components.Position.x[centre]).toBeCloseTo(0.15, 14);
      return Array.from(world.components.Position.x.subarray(0, 5002));
    };
    expect(run(true)).toEqual(run(false));
  });

  test('2D equals 3D with z = 0, bit for bit', () => {
    const run = (dimensions: 2 | 3) => {
      const { world } = orbit({ x: 80, y: -40 }, { dimensions });
      for (let i = 0; i < 1000; i++) step(world, 1 / 60);
      const { x, y, z } = world.components.Position;
      return [x[2], y[2], z[2]];
    };
    expect(run(2)).toEqual(run(3));
  });

  test('f32 handles planets a light-hour away', () => {
    const world = createPhysicsWorld({ precision: 'f32', capacity: 10, forces: [attractors()] });
    spawn(world, { position: {}, attractor: 1.32712440018e20 });
    const pluto = spawn(world, { position: { x: 7e12 }, velocity: {}, mass: 1 });
    expect(forceOn(world, pluto).x / (-1.32712440018e20 / 49e24)).toBeCloseTo(1, 5);
  });

  test('centres can be added and removed', () => {
    const world = createPhysicsWorld({ capacity: 100, forces: [attractors()] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 0.1);
    expect(world.components.Velocity.x[body]).toBe(0);
    for (let i = 0; i < 40; i++) spawn(world, { position: { x: 10 }, attractor: 1 });
    step(world, 0.1);
    expect(world.components.Velocity.x[body]).toBeCloseTo((40 / 100) * 0.1, 4);
  });
});

describe('with a speed of light', () => {
  /** The horizons are 2 μ/c² = 1 m. */
  const HOLES = attractors({ lightSpeed: 10 });
  const MU = 50;

  test.each(['f32', 'f64'] as const)('a black hole has the force of paczynskiWiita, %s', (precision) => {
    const size = precision === 'f32' ? 1e-6 : 1e-14;
    for (const dimensions of [2, 3] as const) {
      const start = { position: { x: 1.7, y: -2.2, z: dimensions === 3 ? 0.8 : 0 }, velocity: {}, mass: 3 };
      const moved = [HOLES, paczynskiWiita({ mu: MU, horizon: 1 })].map((force) => {
        const world = createPhysicsWorld({ dimensions, precision, capacity: 3, forces: [force] });
        if (force === HOLES) spawn(world, { position: {}, attractor: MU });
        const body = spawn(world, start);
        const potential = energy(world).potential;
        step(world, 0.01);
        const { x, y, z } = world.components.Velocity;
        return [x[body], y[body], z[body], potential];
      });
      for (const [i, value] of moved[0].entries()) {
        expect(Math.abs(value - moved[1][i])).toBeLessThanOrEqual(size * Math.abs(value));
      }
      expect(Math.hypot(...moved[0].slice(0, 3))).toBeGreaterThan(0.05);
    }
  });

  test('the force is zero at the horizon and inside', () => {
    for (const x of [1, 0.999, 0.3, 0]) {
      const world = createPhysicsWorld({ capacity: 3, forces: [HOLES] });
      spawn(world, { position: {}, attractor: MU });
      const body = spawn(world, { position: { x }, velocity: {}, mass: 1 });
      expect(energy(world).potential).toBeCloseTo(0, 12);
      step(world, 0.01);
      expect([world.components.Position.x[body], world.faults.faults.length]).toEqual([x, 0]);
    }
  });

  test.each([
    [3.3, 'stays'],
    [2.7, 'falls in'],
  ] as const)('a body pushed inwards from a circle of %d horizons %s', (radius, fate) => {
    const world = createPhysicsWorld({ capacity: 3, forces: [HOLES], integrator: rungeKutta4 });
    spawn(world, { position: {}, attractor: MU });
    // The speed follows from v² / r = μ/(r - r_s)², reduced by 0.1 %: circles are stable beyond three horizons.
    const speed = (0.999 * Math.sqrt(MU * radius)) / (radius - 1);
    const body = spawn(world, { position: { x: radius }, velocity: { y: speed }, mass: 1 });
    const { x, y } = world.components.Position;
    let near: number = radius;
    for (let i = 0; i < 20_000 && near > 1; i++) {
      step(world, 1e-3);
      near = Math.min(near, Math.hypot(x[body], y[body]));
    }
    // At 3.3 horizons the orbit oscillates by 2 δr = 4 · 10⁻³ r Ω²/κ² = 4 · 10⁻³ r (r - 1)/(r - 3) = 0.1 m.
    if (fate === 'stays') expect(near).toBeGreaterThan(radius - 0.12);
    else expect(near).toBeLessThan(1.05);
  });

  test('a speed of light of zero is refused', () => {
    expect(() => attractors({ lightSpeed: 0 })).toThrow(/lightSpeed/);
    expect(() => attractors({ lightspeed: 3 } as never)).toThrow(/lightspeed/);
  });
});
