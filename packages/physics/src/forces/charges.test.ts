import { describe, expect, test } from 'vitest';
import { forceOn, lawOn, read, run, single, slope } from '../../../../test/support/laws.ts';
import {
  accelerationField,
  COULOMB_CONSTANT,
  createPhysicsWorld,
  electricField,
  energy,
  type Field,
  fixedCharges,
  forceField,
  magneticField,
  PhysicsError,
  rungeKutta4,
  spawn,
  step,
  velocityVerlet,
} from '../index.ts';

describe('electric field', () => {
  test('a steady field conserves energy, and the path is a parabola', () => {
    const law = electricField({ x: 2, y: -3 });
    const { world, at } = single([law], { velocity: { x: 1 }, mass: 4, charge: 2 });
    const before = energy(world).total;
    run(world, 10);
    expect(at().x).toBeCloseTo(10 + 0.5 * 1 * 100, 10);
    expect(at().y).toBeCloseTo(-0.5 * 1.5 * 100, 10);
    expect(energy(world).total).toBeCloseTo(before, 9);
  });

  test('a field that throws is reported once, and its last valid value is used', () => {
    const law = electricField((t) => {
      if (t > 0.5) throw new Error('no more');
      return { x: 1 };
    });
    const { world, going } = single([law], { charge: 1 });
    for (let i = 0; i < 4; i++) step(world, 0.1);
    expect(() => run(world, 0.4, 0.1)).toThrow(AggregateError);
    expect(going().x).toBeGreaterThan(0.45);
  });
});

describe('magnetic field', () => {
  test('does no work and rotates the velocity at q B/m with every integrator', () => {
    for (const integrator of [velocityVerlet, rungeKutta4]) {
      const body = { velocity: { x: 3 }, mass: 2, charge: 4 };
      const { world, going, speed } = single([magneticField({ z: 0.5 })], body, { integrator });
      run(world, 2 * Math.PI, 1e-3);
      expect(speed()).toBeCloseTo(3, 5);
      expect(going().x).toBeCloseTo(3, 5);
    }
  });

  test('a growing field B(t) rotates the velocity by ∫ q B/m dt and does no work', () => {
    const body = { velocity: { x: 3 }, mass: 2, charge: 4 };
    const law = magneticField((t) => ({ z: 0.5 + 0.3 * t }));
    const { world, going, speed } = single([law], body, { integrator: rungeKutta4 });
    run(world, 2, 1e-3);
    // Clockwise for a positive charge; the error of Runge-Kutta 4 is about (q B dt/m)⁴ · 2000 steps / 120 = 1e-10.
    const angle = -(4 / 2) * (0.5 * 2 + (0.3 * 2 ** 2) / 2);
    expect(going().x).toBeCloseTo(3 * Math.cos(angle), 9);
    expect(going().y).toBeCloseTo(3 * Math.sin(angle), 9);
    expect(speed()).toBeCloseTo(3, 9);
  });

  test('F = q v × B in 3D', () => {
    const body = { velocity: { x: 1, y: 2, z: 3 }, charge: 2 };
    const force = lawOn(magneticField({ x: 4, y: 5, z: 6 }), body, { dimensions: 3 });
    expect(force).toMatchObject({ x: 2 * (2 * 6 - 3 * 5), y: 2 * (3 * 4 - 1 * 6), z: 2 * (1 * 5 - 2 * 4) });
    expect(lawOn(magneticField({ z: 6 }), { velocity: { x: 1, y: 2 }, charge: 2 })).toMatchObject({ x: 24, y: -12 });
  });

  test('crossed fields drift at E/B', () => {
    const { world, at } = single(
      [electricField({ y: 3 }), magneticField({ z: 2 })],
      { charge: 1 },
      {
        integrator: rungeKutta4,
      },
    );
    run(world, 20 * Math.PI, 1e-3 * Math.PI);
    expect(at().x / (20 * Math.PI)).toBeCloseTo(1.5, 6);
    expect(at().y).toBeCloseTo(0, 6);
  });
});

describe('fixed charges', () => {
  test('like charges repel with k q Q/d², consistent with the potential', () => {
    const world = createPhysicsWorld({ capacity: 10, dimensions: 3, forces: [fixedCharges()] });
    spawn(world, { position: {}, charge: 3e-6 });
    spawn(world, { position: { y: 1 }, charge: -1e-6 });
    const body = spawn(world, { position: { x: 2, z: 1 }, velocity: {}, mass: 1, charge: 2e-6 });
    const force = forceOn(world, body);
    const down = slope(world, body);
    for (const axis of ['x', 'y', 'z'] as const) expect(force[axis]).toBeCloseTo(down[axis], 8);
    expect(COULOMB_CONSTANT * 4 * Math.PI * 8.8541878188e-12).toBeCloseTo(1, 9);
  });

  test('the force is zero inside a source, on sources and on uncharged bodies', () => {
    const world = createPhysicsWorld({ capacity: 10, forces: [fixedCharges(1)] });
    const source = spawn(world, { position: {}, velocity: {}, charge: 5, collider: 2 });
    const inside = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1, charge: 1 });
    const outside = spawn(world, { position: { x: 5 }, velocity: {}, mass: 1, charge: 1 });
    const neutral = spawn(world, { position: { x: 5 }, velocity: { y: 1 }, mass: 1 });
    expect(forceOn(world, inside).x).toBe(0);
    expect(forceOn(world, outside).x).toBeCloseTo(0.2, 15);
    expect(forceOn(world, neutral).x).toBe(0);
    run(world, 1);
    expect(read(world, source).at()).toEqual({ x: 0, y: 0, z: 0 });
    expect(read(world, neutral).at().x).toBe(5);
  });

  test('sources can be added and removed', () => {
    const world = createPhysicsWorld({ capacity: 100, forces: [fixedCharges(1)] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 1, charge: 1 });
    step(world, 0.1);
    expect(world.components.Velocity.x[body]).toBe(0);
    for (let i = 0; i < 40; i++) spawn(world, { position: { x: 10 }, charge: -1 });
    expect(forceOn(world, body).x).toBeCloseTo(0.4, 14);
  });

  test('f32 and f64 agree, in 2D and 3D', () => {
    const pushed = (precision: 'f32' | 'f64', dimensions: 2 | 3) => {
      const world = createPhysicsWorld({ capacity: 10, precision, dimensions, forces: [fixedCharges(2)] });
      spawn(world, { position: { x: 1, y: 2 }, charge: 3 });
      const body = spawn(world, { position: { x: 4, y: 6 }, velocity: {}, mass: 1, charge: 5 });
      return forceOn(world, body);
    };
    expect(pushed('f64', 2)).toEqual(pushed('f64', 3));
    expect(pushed('f64', 2).x).toBeCloseTo((30 / 125) * 3, 14);
    expect(pushed('f32', 2).x).toBeCloseTo((30 / 125) * 3, 6);
  });
});

describe('user-defined fields', () => {
  test('an acceleration field with a potential conserves energy', () => {
    const law = accelerationField(
      (x, y, _z, _t, out) => {
        out.x = -4 * x;
        out.y = -4 * y;
      },
      { potential: (x, y) => 2 * (x * x + y * y) },
    );
    const { world, at } = single([law], { position: { x: 3, y: 1 }, mass: 5 }, { integrator: rungeKutta4 });
    const before = energy(world).total;
    run(world, Math.PI, 1e-3);
    expect(at().x).toBeCloseTo(3, 9);
    expect(energy(world).total / before).toBeCloseTo(1, 10);
  });

  test('a force field is independent of mass and gets the time', () => {
    const law = forceField((_x, _y, _z, t, out) => {
      out.z = t;
    });
    const { world, eid } = single([law], { mass: 5 }, { dimensions: 3 });
    expect(forceOn(world, eid, 7).z).toBe(7);
    expect(forceOn(world, eid, 0).z).toBe(0);
  });

  test.each([
    ['accelerationField', accelerationField],
    ['forceField', forceField],
  ])('%s says so when the function returns the field instead of writing it', (_, make) => {
    const { world } = single([make((() => ({ x: 20, y: 0 })) as Field, { name: 'breeze' })], { mass: 5 });
    expect(() => step(world, 0.1)).toThrow(
      /E_TYPE: "breeze" returned an object and wrote nothing to `out`\. Write to it: \(x, y, z, t, out\) =>/,
    );
  });

  test('may return what they like once they have written, and the number that they wrote, 0 too', () => {
    const fields: Field[] = [
      (x, _y, _z, _t, out) => (out.x = -4 * x),
      (_x, _y, _z, _t, out) => Object.assign(out, { x: -12 }),
      (_x, _y, _z, _t, out) => Object.assign(out, { x: 0 }),
    ];
    const forces = fields.map((field) => {
      const { world, eid } = single([forceField(field)], { position: { x: 3 }, mass: 5 });
      step(world, 1e-9);
      return forceOn(world, eid).x;
    });
    expect(forces).toEqual([-12, -12, 0]);
    const { world } = single([forceField(fields[0])], { position: {}, mass: 5 });
    expect(() => step(world, 0.1)).not.toThrow();
  });

  test('refuse values that are no functions, and unknown options', () => {
    expect(() => forceField({} as never)).toThrow(PhysicsError);
    expect(() => accelerationField(() => {}, { potenial: () => 0 } as never)).toThrow(/potenial/);
    expect(() => fixedCharges(0)).toThrow(PhysicsError);
    expect(() => magneticField({ z: Number.POSITIVE_INFINITY })).toThrow(PhysicsError);
  });
});
