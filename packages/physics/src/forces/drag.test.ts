import { describe, expect, test } from 'vitest';
import type { BodyInput } from '../bodies/body-input.ts';
import { spawn } from '../bodies/spawn.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { defineForce } from '../laws/force.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { linearDrag, quadraticDrag } from './drag.ts';
import { replaceForce } from './support/replace-force.ts';
import { gusts } from './support/wind.ts';
import { uniformGravity } from './uniform-gravity.ts';

function run(forces: readonly Force[], body: BodyInput, seconds: number, options: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 10, forces, integrator: velocityVerlet, ...options });
  const eid = spawn(world, { position: {}, velocity: {}, mass: 1, ...body });
  for (let i = 0; i < seconds * 60; i++) step(world, 1 / 60);
  const { Position, Velocity } = world.components;
  return { x: Position.x[eid], y: Position.y[eid], vx: Velocity.x[eid], vy: Velocity.y[eid] };
}

describe('drag', () => {
  test('ch04-fall-with-drag: v(5) and the terminal speed', () => {
    const forces = [uniformGravity({ y: 10 }), linearDrag()];
    expect(Math.abs(run(forces, { linearDrag: 0.5 }, 5).vy - 18.3583)).toBeLessThan(1e-4);
    expect(run(forces, { linearDrag: 0.5 }, 60).vy).toBeCloseTo(20, 9);
    const { y, vy } = run(forces, { linearDrag: 0.5 }, 10);
    expect(y).toBeCloseTo(160.27, 2);
    expect(vy).toBeCloseTo(19.8652, 4);
  });

  test('ch05-projectile-drag: the position after ten seconds', () => {
    const forces = [uniformGravity({ y: 10 }), linearDrag()];
    const start = { position: { x: 50, y: 400 }, velocity: { x: 60, y: -60 }, linearDrag: 0.1 };
    const { x, y } = run(forces, start, 10);
    expect(Math.abs(x - 429.27)).toBeLessThan(0.01);
    expect(Math.abs(y - 388.61)).toBeLessThan(0.01);
  });

  test('ch07-drag-laws: linear and quadratic after five seconds', () => {
    const thrown = { velocity: { x: 20 } };
    expect(run([linearDrag()], { ...thrown, linearDrag: 0.1 }, 5).vx).toBeCloseTo(12.131, 3);
    expect(run([quadraticDrag()], { ...thrown, quadraticDrag: 0.1 }, 5, { integrator: rungeKutta4 }).vx).toBeCloseTo(
      1.8182,
      4,
    );
  });

  test('ch07-terminal-velocity: √(mg/k) with quadratic drag', () => {
    const forces = [uniformGravity({ y: 10 }), quadraticDrag()];
    expect(run(forces, { quadraticDrag: 0.01 }, 60).vy).toBeCloseTo(31.6228, 4);
  });

  test('a negative coefficient is refused', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    expect(() => spawn(world, { position: {}, linearDrag: -1 })).toThrow('E_RANGE');
    expect(() => spawn(world, { position: {}, quadraticDrag: -1 })).toThrow('E_RANGE');
  });
});

describe('wind', () => {
  test('ch07-wind: from rest the relative speed is w0 / (1 + (k/m) w0 t), and zero at the speed of the wind', () => {
    const { vx } = run([quadraticDrag({ x: 40 })], { quadraticDrag: 0.0005 }, 10);
    expect(40 - vx).toBeCloseTo(40 / (1 + 0.0005 * 40 * 10), 5);
    expect(run([quadraticDrag({ x: 40 })], { velocity: { x: 40 }, quadraticDrag: 0.5 }, 1).vx).toBe(40);
  });

  test('changes with time: the mean response of linear drag to a periodic wind', () => {
    const wind = { x: 0 };
    const drag = linearDrag((time) => {
      wind.x = Math.sin(time);
      return wind;
    });
    // The solution of v' = c (sin t - v) is v = c (c sin t - cos t + e^(-c t)) / (1 + c²).
    const [c, t] = [2, 10];
    const exact = (c * (c * Math.sin(t) - Math.cos(t) + Math.exp(-c * t))) / (1 + c * c);
    expect(run([drag], { linearDrag: c }, t, { integrator: rungeKutta4 }).vx).toBeCloseTo(exact, 7);
  });

  test('a wind that throws is reported once per evaluation, and its last valid value is used', () => {
    let bad = false;
    const world = createPhysicsWorld({ capacity: 10, forces: [linearDrag(() => ({ x: bad ? Number.NaN : 3 }))] });
    const eid = spawn(world, { position: {}, velocity: { x: 3 }, mass: 1, linearDrag: 1 });
    step(world, 0.1);
    bad = true;
    let caught: unknown;
    try {
      step(world, 0.1);
    } catch (error) {
      caught = error;
    }
    expect(caught).toBeInstanceOf(AggregateError);
    expect((caught as AggregateError).errors).toHaveLength(1);
    expect(world.components.Velocity.x[eid]).toBe(3);
    expect(world.tick).toBe(2);
  });

  test('an invalid velocity is refused', () => {
    expect(() => linearDrag({ x: Number.NaN })).toThrow('E_NONFINITE');
    expect(() => quadraticDrag({ x: 1e30 })).toThrow('E_RANGE');
    expect(() => quadraticDrag('north' as never)).toThrow('E_TYPE');
  });

  test('ch07-bubbles-turbulence: gusts have the given mean and depend only on time', () => {
    const options = { mean: { x: 20 }, spread: { x: 500, y: 500 }, interval: 0.1, seed: 4 };
    const gust = gusts(options);
    const n = 5000;
    const sum = { x: 0, y: 0 };
    for (let i = 0; i < n; i++) {
      const { x, y } = gust((i + 0.5) * 0.1);
      sum.x += x / n;
      sum.y += y / n;
    }
    const sigma = 500 / Math.sqrt(3) / Math.sqrt(n);
    expect(Math.abs(sum.x - 20)).toBeLessThan(3 * sigma);
    expect(Math.abs(sum.y)).toBeLessThan(3 * sigma);
    const again = gusts(options);
    expect({ ...again(7.01) }).toEqual({ ...gust(7.09) });
    expect({ ...again(7.01) }).not.toEqual({ ...gust(7.11) });
  });
});

describe('forces that change at run time', () => {
  function falling(): { world: PhysicsWorld; eid: number } {
    const world = createPhysicsWorld({ capacity: 10, forces: [linearDrag(), uniformGravity({ y: -10 })] });
    return { world, eid: spawn(world, { position: {}, velocity: {}, mass: 1 }) };
  }

  test('gravity is replaced by name, and an invalid value leaves it unchanged', () => {
    const { world, eid } = falling();
    replaceForce(world, uniformGravity({ y: 5 }));
    expect(() => replaceForce(world, uniformGravity({ y: Number.NaN }))).toThrow('E_NONFINITE');
    step(world, 1);
    expect(world.components.Velocity.y[eid]).toBe(5);
    expect(world.forces).toHaveLength(2);
    expect(world.forces[1].parameters?.accelerationY.value).toBe(5);
  });

  test('a missing or invalid force is refused', () => {
    const { world } = falling();
    const before = [...world.forces];
    expect(() => replaceForce(world, quadraticDrag())).toThrow('E_UNKNOWN');
    expect(() => replaceForce(world, uniformGravity(), quadraticDrag())).toThrow('E_UNKNOWN');
    expect(() => replaceForce(world, {} as never)).toThrow('E_TYPE');
    expect(world.forces).toEqual(before);
  });

  test('a replacement during a step takes effect at its end', () => {
    const { world, eid } = falling();
    const off = uniformGravity({});
    world.phases.input.push((w) => replaceForce(w, off));
    step(world, 1);
    expect(world.components.Velocity.y[eid]).toBe(-10);
    step(world, 1);
    expect(world.components.Velocity.y[eid]).toBe(-10);
  });
});

describe('user-defined forces', () => {
  const swirl = defineForce({
    name: 'swirl',
    accumulate(world, first, last) {
      const { x: fx, y: fy } = world.scratch.force;
      const { x, y } = world.components.Position;
      for (let eid = first; eid < last; eid++) {
        fx[eid] -= y[eid];
        fy[eid] += x[eid];
      }
    },
  });

  test('give the same result in chunks and over the whole range', () => {
    const run = (force: Force) => {
      const world = createPhysicsWorld({ capacity: 10_000, forces: [uniformGravity(), force] });
      for (let i = 0; i < 9000; i++) spawn(world, { position: { x: i, y: 1 }, velocity: {}, mass: 1 + i });
      for (let i = 0; i < 3; i++) step(world, 0.01);
      return Array.from(world.components.Velocity.y);
    };
    expect(run(swirl)).toEqual(run({ ...swirl, local: false }));
  });

  test('a force that throws is reported, the others act, and the world continues', () => {
    const world = createPhysicsWorld({ capacity: 10, forces: [uniformGravity({ y: -10 })] });
    const eid = spawn(world, { position: {}, velocity: {}, mass: 1 });
    const broken = () => {
      throw new Error('broken');
    };
    world.forces.push(defineForce({ name: 'broken', accumulate: broken }));
    expect(() => step(world, 1)).toThrow(AggregateError);
    expect(world.components.Velocity.y[eid]).toBe(-10);
    world.forces.pop();
    step(world, 1);
    expect(world.components.Velocity.y[eid]).toBe(-20);
  });

  test('a force that throws in prepare prevents the step', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    const refuse = () => {
      throw new Error('not now');
    };
    world.forces.push(defineForce({ name: 'refuses', accumulate: () => {}, prepare: refuse }));
    expect(() => step(world, 1)).toThrow('not now');
    expect(world.tick).toBe(0);
    world.forces.pop();
    step(world, 1);
    expect(world.tick).toBe(1);
  });

  test('NaN does not spread, and 1e308 stays finite', () => {
    for (const value of [Number.NaN, 1e308, -Infinity]) {
      const world = createPhysicsWorld({ capacity: 10, forces: [uniformGravity({ y: -10 })] });
      const [a, b] = [0, 1].map((x) => spawn(world, { position: { x }, velocity: {}, mass: 1 }));
      world.forces.push(
        defineForce({
          name: 'poison',
          accumulate: (w) => {
            w.scratch.force.x[a] += value;
          },
        }),
      );
      step(world, 0.1);
      const { Position, Velocity } = world.components;
      for (const column of [Position.x, Position.y, Velocity.x, Velocity.y]) {
        expect(Number.isFinite(column[a])).toBe(true);
      }
      expect(Velocity.y[b]).toBe(-1);
      expect(world.faults.faults.length).toBeGreaterThan(0);
    }
  });
});
