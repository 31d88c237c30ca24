import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { energy } from '../diagnostics/energy.ts';
import { linearDrag, quadraticDrag } from '../forces/drag.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { defineForce } from '../laws/force.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { Force, Integrator, PhysicsWorld } from '../world/types.ts';
import { rungeKutta4 } from './runge-kutta-4.ts';
import { semiImplicitEuler } from './semi-implicit-euler.ts';
import { velocityVerlet } from './velocity-verlet.ts';

const ALL = [semiImplicitEuler, velocityVerlet, rungeKutta4];

interface Case {
  readonly forces: readonly Force[];
  readonly body: Parameters<typeof spawn>[1];
  /** The exact x at time T. */
  readonly exact: number;
  readonly time: number;
}

/** x of one body after `steps` equal steps. */
function solve({ forces, body, time }: Case, integrator: Integrator, steps: number): number {
  const world = createPhysicsWorld({ capacity: 10, forces, integrator });
  const anchor = spawn(world, { position: {} });
  const eid = spawn(world, body);
  if (forces.some(({ name }) => name === 'springs')) {
    spawn(world, { spring: { a: anchor, b: eid, stiffness: 10, damping: 0.5 } });
  }
  for (let i = 0; i < steps; i++) step(world, time / steps);
  return world.components.Position.x[eid];
}

/** The order of the error between three step lengths, each half the one before. */
function orders(problem: Case, integrator: Integrator, steps: number): number[] {
  const errors = [1, 2, 4].map((n) => Math.abs(solve(problem, integrator, n * steps) - problem.exact));
  return [Math.log2(errors[0] / errors[1]), Math.log2(errors[1] / errors[2])];
}

const push = defineForce({
  name: 'push that varies with time',
  accumulate(world, first, last, time) {
    for (let eid = first; eid < last; eid++)
      world.scratch.force.x[eid] += world.components.Mass.value[eid] * Math.cos(time);
  },
});

// x'' = -10 x - 0.5 x', x(0) = 1: the exact solution of ch08-damped.
const gamma = 0.25;
const omega = Math.sqrt(10 - gamma * gamma);
const T = 1.3;
const damped = Math.exp(-gamma * T) * (Math.cos(omega * T) + (gamma / omega) * Math.sin(omega * T));

const CASES: Record<string, Case> = {
  'damped oscillator': {
    forces: [springs()],
    body: { position: { x: 1 }, velocity: {}, mass: 1 },
    exact: damped,
    time: T,
  },
  'linear drag': {
    forces: [linearDrag()],
    body: { position: {}, velocity: { x: 1 }, mass: 2, linearDrag: 3 },
    exact: (2 / 3) * (1 - Math.exp(-1.5)),
    time: 1,
  },
  'quadratic drag': {
    forces: [quadraticDrag()],
    body: { position: {}, velocity: { x: 10 }, mass: 2, quadraticDrag: 0.3 },
    exact: (2 / 0.3) * Math.log(1 + (0.3 * 10) / 2),
    time: 1,
  },
  'a force of time': {
    forces: [push],
    body: { position: {}, velocity: {}, mass: 2 },
    exact: 1 - Math.cos(2),
    time: 2,
  },
};

describe('order of convergence', () => {
  for (const [name, problem] of Object.entries(CASES)) {
    for (const integrator of ALL) {
      test(`${name}, ${integrator.name}: ${integrator.order}`, () => {
        // Enough steps for the asymptotic regime, few enough to stay above rounding.
        const steps = [0, 4000, 400, 0, 32][integrator.order];
        for (const order of orders(problem, integrator, steps)) {
          expect(Math.abs(order - integrator.order)).toBeLessThan(0.1);
        }
      });
    }
  }
});

describe('exact results', () => {
  test('constant force: Verlet and Runge-Kutta follow the parabola, Euler is off by g dt t / 2 (ch04-projectile)', () => {
    for (const integrator of ALL) {
      const world = createPhysicsWorld({ capacity: 10, integrator, forces: [uniformGravity({ y: -10 })] });
      const ball = spawn(world, { position: { x: 100 }, velocity: { x: 20, y: 80 }, mass: 1 });
      for (let i = 0; i < 960; i++) step(world, 1 / 60);
      const { x, y } = world.components.Position;
      expect(x[ball]).toBeCloseTo(420, 9);
      expect(y[ball]).toBeCloseTo(integrator === semiImplicitEuler ? -(10 / 60) * 8 : 0, 9);
    }
  });

  test('no force: velocity is kept to the last bit', () => {
    for (const integrator of ALL) {
      const world = createPhysicsWorld({ capacity: 10, integrator, forces: [uniformGravity(), linearDrag()] });
      const massless = spawn(world, { position: {}, velocity: { x: 0.1, y: 0.7 } });
      for (let i = 0; i < 100; i++) step(world, 1 / 60);
      expect(world.components.Velocity.x[massless]).toBe(0.1);
      expect(world.components.Velocity.y[massless]).toBe(0.7);
    }
  });
});

/** One body on an undamped spring of k = 1 from the origin. */
function oscillator(options: PhysicsWorldOptions): { world: PhysicsWorld; ball: number } {
  const world = createPhysicsWorld({ capacity: 10, forces: [springs()], ...options });
  const anchor = spawn(world, { position: {} });
  const ball = spawn(world, { position: { x: -250 }, velocity: {}, mass: 1 });
  spawn(world, { spring: { a: anchor, b: ball, stiffness: 1 } });
  return { world, ball };
}

describe('long runs', () => {
  test('energy stays in its bound for ever, or decays as theory says (ch08-free-oscillations)', () => {
    const dt = 1 / 60;
    for (const [integrator, bound] of [
      [semiImplicitEuler, (1.01 * dt) / 2],
      [velocityVerlet, (1.01 * dt * dt) / 4],
      [rungeKutta4, (1.01 * 10_000 * dt ** 6) / 72],
    ] as const) {
      const { world } = oscillator({ integrator });
      const start = energy(world).total;
      let worst = 0;
      for (let i = 0; i < 10_000; i++) {
        step(world, dt);
        worst = Math.max(worst, Math.abs(energy(world).total / start - 1));
      }
      expect(worst, integrator.name).toBeLessThan(bound);
      expect(worst, integrator.name).toBeGreaterThan(0.9 * bound);
    }
  });

  test('the period of symplectic Euler is π dt / asin(ω dt / 2)', () => {
    const { world, ball } = oscillator({ integrator: semiImplicitEuler });
    const { x } = world.components.Position;
    let crossings = 0;
    let [first, last] = [0, 0];
    for (let i = 0; i < 60 * 100; i++) {
      const before = x[ball];
      step(world, 1 / 60);
      if (!(before < 0 && x[ball] >= 0)) continue;
      last = world.time - (1 / 60) * (x[ball] / (x[ball] - before));
      if (crossings++ === 0) first = last;
    }
    expect((last - first) / (crossings - 1)).toBeCloseTo(6.2831126, 4);
  });

  test('Verlet comes back the way it went', () => {
    const { world, ball } = oscillator({ integrator: velocityVerlet });
    const { Position, Velocity } = world.components;
    for (let i = 0; i < 1000; i++) step(world, 0.05);
    Velocity.x[ball] *= -1;
    for (let i = 0; i < 1000; i++) step(world, 0.05);
    expect(Position.x[ball]).toBeCloseTo(-250, 8);
    expect(Velocity.x[ball]).toBeCloseTo(0, 8);
  });

  test('f32 follows f64', () => {
    for (const integrator of ALL) {
      const [single, double] = (['f32', 'f64'] as const).map((precision) => {
        const { world, ball } = oscillator({ integrator, precision });
        for (let i = 0; i < 600; i++) step(world, 1 / 60);
        return world.components.Position.x[ball];
      });
      expect(Math.abs(single - double)).toBeLessThan(250 * 600 * 2 ** -24);
      expect(single).not.toBe(double);
    }
  });
});

test('a plane is space with z = 0, bit for bit', () => {
  for (const integrator of ALL) {
    const [plane, space] = ([2, 3] as const).map((dimensions) => {
      const forces = [uniformGravity(), linearDrag({ x: 1 }), quadraticDrag({ x: 2 }), springs()];
      const world = createPhysicsWorld({ capacity: 10, dimensions, integrator, forces });
      const a = spawn(world, { position: { x: 0.3 } });
      const body = { velocity: { x: 1, y: 0.3 }, mass: 2, linearDrag: 0.1, quadraticDrag: 0.2 };
      const b = spawn(world, { position: { x: 1, y: 2 }, ...body });
      spawn(world, { spring: { a, b, stiffness: 20, damping: 0.1, length: 1 } });
      for (let i = 0; i < 500; i++) step(world, 1 / 60);
      const { Position, Velocity } = world.components;
      return [Position.x[b], Position.y[b], Position.z[b], Velocity.x[b], Velocity.y[b], Velocity.z[b]];
    });
    expect(plane).toEqual(space);
  }
});
