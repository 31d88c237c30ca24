/** Conserved quantities and their accuracy: distant positions, scale, energy and momentum. */
import {
  boxWalls,
  createPhysicsWorld,
  defineForce,
  energy,
  type Integrator,
  momentum,
  type PhysicsWorld,
  rungeKutta4,
  semiImplicitEuler,
  spawn,
  springs,
  step,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { steps } from '../support/worlds.ts';

describe('numerics', () => {
  it('82 at x = 1e6 m a body of 1 m/s moves by 1.000 m in a second, to 1e-9 m', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    const eid = spawn(world, { position: { x: 1e6 }, velocity: { x: 1 } });
    // 64 steps of 1/64 s, which numbers 1.2e-10 m apart (2⁻³³, as they are out there) take without rounding.
    steps(world, 64, 1 / 64);
    expect(Math.abs(world.components.Position.x[eid] - 1e6 - 1)).toBeLessThan(1e-9);
    // Of 60 steps of 1/60 s each is rounded by at most half of that distance.
    steps(world, 60, 1 / 60);
    expect(Math.abs(world.components.Position.x[eid] - 1e6 - 2)).toBeLessThanOrEqual(60 * 2 ** -34);
  });

  /** Bodies on springs, moving in a box, with all lengths in units of `unit` metres. */
  function scaledPositions(unit: number): number[] {
    const world = createPhysicsWorld({
      capacity: 100,
      forces: [uniformGravity({ y: -9.8 * unit }), springs()],
      walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 10 * unit, y: 10 * unit }, restitution: 0.9 })],
    });
    const ids = Array.from({ length: 20 }, (_, i) =>
      spawn(world, {
        position: { x: (0.5 + ((i * 7) % 9)) * unit, y: (1 + (i % 8)) * unit },
        velocity: { x: (i - 10) * unit, y: (i % 3) * unit },
        mass: 1 + i,
        collider: { radius: 0.125 * unit },
      }),
    );
    for (let i = 1; i < 20; i += 2) {
      spawn(world, { spring: { a: ids[i - 1], b: ids[i], stiffness: 40, length: unit } });
    }
    steps(world, 120);
    const { x, y } = world.components.Position;
    return ids.flatMap((eid) => [x[eid] / unit, y[eid] / unit]);
  }

  it('83 a scene scaled by 128 equals the unscaled one to the last bit', () => {
    // Multiplying by a power of two is exact, so is everything that follows: 9.8 · 128 too.
    expect(scaledPositions(128)).toEqual(scaledPositions(1));
  });

  it('83 a scene scaled by 100 equals the unscaled one to what rounding leaves', () => {
    const [plain, scaled] = [scaledPositions(1), scaledPositions(100)];
    // Positions of 10 m are rounded by 1e-15 a step; 120 steps of springs and bounces make at most ten thousand of it.
    for (let i = 0; i < plain.length; i++) expect(Math.abs(scaled[i] - plain[i])).toBeLessThan(1e-11);
  });
});

/** A force of -ω² x per mass on every body. */
function harmonic(omega: number) {
  return defineForce({
    name: 'harmonic',
    accumulate({ scratch, components: { Position, Mass } }, first, last) {
      for (let eid = first; eid < last; eid++) scratch.force.x[eid] -= omega ** 2 * Mass.value[eid] * Position.x[eid];
    },
  });
}

describe('energy', () => {
  const [omega, dt, count] = [3, 0.02, 20_000];
  const phase = omega * dt;

  /** Returns the largest relative error of v² + ω² x² over the run, and the error at its end. */
  function drift(integrator: Integrator): { worst: number; last: number } {
    const world = createPhysicsWorld({ capacity: 10, integrator, forces: [harmonic(omega)] });
    const eid = spawn(world, { position: { x: 1 }, velocity: {}, mass: 2 });
    const { Position, Velocity } = world.components;
    const total = () => Velocity.x[eid] ** 2 + omega ** 2 * Position.x[eid] ** 2;
    const start = total();
    let [worst, last] = [0, 0];
    for (let i = 0; i < count; i++) {
      step(world, dt);
      last = total() / start - 1;
      worst = Math.max(worst, Math.abs(last));
    }
    return { worst, last };
  }

  it('86 semi-implicit Euler keeps it within ω dt / 2, for ever', () => {
    // It conserves v² + ω² x² - ω² dt x v. The last term is at most ω dt / 2 of the first two, and 0 at the start.
    const { worst } = drift(semiImplicitEuler);
    expect(worst).toBeLessThan((1 + phase) * (phase / 2));
    expect(worst).toBeGreaterThan(0.9 * (phase / 2));
  });

  it('86 velocity Verlet keeps it within (ω dt)² / 4, for ever', () => {
    // It conserves v² + ω² x² (1 - (ω dt)² / 4): at x = 0 the energy is lower by that part than at the start.
    const { worst } = drift(velocityVerlet);
    expect(worst).toBeLessThan(1.01 * (phase ** 2 / 4));
    expect(worst).toBeGreaterThan(0.9 * (phase ** 2 / 4));
  });

  it('86 Runge-Kutta 4 loses (ω dt)⁶ / 72 of it a step', () => {
    // |1 + iφ - φ²/2 - iφ³/6 + φ⁴/24|² = 1 - φ⁶/72 + φ⁸/576.
    const expected = (1 - phase ** 6 / 72 + phase ** 8 / 576) ** count - 1;
    expect(drift(rungeKutta4).last / expected).toBeCloseTo(1, 3);
  });
});

describe('momentum', () => {
  function pair(dimensions: 2 | 3, integrator: Integrator): PhysicsWorld {
    const world = createPhysicsWorld({ dimensions, integrator, capacity: 10, forces: [springs()] });
    const a = spawn(world, { position: { x: -1 }, velocity: { x: 3, y: 1 }, mass: 2 });
    const b = spawn(world, { position: { x: 1, y: 0.5 }, velocity: { y: -4 }, mass: 5 });
    spawn(world, { spring: { a, b, stiffness: 300, damping: 0.2, length: 1 } });
    return world;
  }

  it.each([semiImplicitEuler, velocityVerlet, rungeKutta4])(
    '87 of an isolated pair stays to 1e-12: $name',
    (integrator) => {
      for (const dimensions of [2, 3] as const) {
        const world = pair(dimensions, integrator);
        const start = momentum(world);
        steps(world, 2000, 1 / 120);
        const end = momentum(world);
        // Relative to the 26 kg m/s that go to and fro. Forces are opposite to the last bit; what is left is the
        // rounding of velocities, 1.1e-16 a step and body and random in sign: some 1.1e-16 · √4000 = 7e-15.
        for (const axis of ['x', 'y', 'z'] as const) expect(Math.abs(end[axis] - start[axis])).toBeLessThan(26e-12);
        expect(Math.abs(energy(world).total)).toBeGreaterThan(1);
      }
    },
  );
});
