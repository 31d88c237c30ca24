import { describe, expect, test } from 'vitest';
import { forceOn, run, single } from '../../../../test/support/laws.ts';
import {
  corneringGrip,
  energy,
  lift,
  planeSupport,
  quadraticDrag,
  rungeKutta4,
  step,
  stringTension,
  thrust,
  uniformGravity,
} from '../index.ts';

const gravity = uniformGravity({ y: -10 });

describe('string tension', () => {
  test('a conical pendulum has T = mg/cosθ and constant height', () => {
    const [length, angle] = [2, 0.6];
    const [r, h] = [length * Math.sin(angle), length * Math.cos(angle)];
    const speed = Math.sqrt(10 * r * Math.tan(angle));
    const body = { position: { x: r, y: -h }, velocity: { z: speed }, mass: 3 };
    const options = { dimensions: 3 as const, integrator: rungeKutta4 };
    const { world, eid, at } = single([gravity, stringTension({ length })], body, options);
    const force = forceOn(world, eid);
    expect(force.y + 30).toBeCloseTo(30, 10);
    expect(Math.hypot(force.x, force.y + 30)).toBeCloseTo(30 / Math.cos(angle), 10);
    run(world, 20);
    expect(at().y).toBeCloseTo(-h, 5);
    expect(Math.hypot(at().x, at().y, at().z)).toBeCloseTo(length, 6);
  });

  test.each([30, 60, 90])('a pendulum of %d° keeps its length, and its swing', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const swing = (perPeriod: number) => {
      const body = { position: { x: Math.sin(angle), y: -Math.cos(angle) } };
      const { world, at } = single([gravity, stringTension({ length: 1 })], body, { integrator: rungeKutta4 });
      const before = energy(world).total;
      let worst = 0;
      for (let i = 0; i < 10 * perPeriod; i++) {
        step(world, (2 * Math.PI) / Math.sqrt(10) / perPeriod);
        worst = Math.max(worst, Math.abs(Math.hypot(at().x, at().y) - 1));
      }
      return { length: worst, energy: Math.abs(energy(world).total - before) / 10 };
    };
    const [coarse, fine] = [swing(100), swing(200)];
    // Errors of a fourth-order scheme, a fraction of (ω dt)⁴ = 1.6·10⁻⁵ in a swing, which fall by 2⁴ or at least 2³ (energy);
    // at 90° the string goes slack for a moment at each end, which leaves a lower order. They would not fall if the
    // correction damped the swing. Without it the length changes by up to 3.6.
    expect(coarse.length).toBeLessThan(3e-6);
    expect(fine.length).toBeLessThan(coarse.length / (degrees < 90 ? 10 : 4));
    expect(coarse.energy).toBeLessThan(2e-5);
    expect(fine.energy).toBeLessThan(coarse.energy / (degrees < 90 ? 6 : 2));
  });

  test('a string that becomes taut with a jerk takes the speed along it, and no other', () => {
    const body = { position: { y: -0.5 }, velocity: { x: 1, y: -1 } };
    const { world, eid, at } = single([stringTension({ length: 1 })], body, { integrator: rungeKutta4 });
    const { x: u, y: v } = world.components.Velocity;
    run(world, 0.4, 1e-3);
    const angularMomentum = () => at().x * v[eid] - at().y * u[eid];
    expect(angularMomentum()).toBeCloseTo(0.5, 12);
    run(world, 10, 1e-3);
    // The force points to the pivot, so the angular momentum stays, to the fourth order.
    expect(angularMomentum()).toBeCloseTo(0.5, 8);
    expect(Math.hypot(at().x, at().y)).toBeCloseTo(1, 8);
    expect(Math.hypot(u[eid], v[eid])).toBeCloseTo(0.5, 8);
  });

  test('a slack string exerts no force, and a taut one never pushes', () => {
    const law = stringTension({ length: 2 });
    const inside = single([gravity, law], { position: { y: -1 } });
    expect(forceOn(inside.world, inside.eid).y).toBe(-10);
    const above = single([gravity, law], { position: { y: 2 } });
    expect(forceOn(above.world, above.eid).y).toBe(-10);
    const below = single([gravity, law], { position: { y: -2 } });
    expect(forceOn(below.world, below.eid).y).toBe(0);
  });
});

describe('cornering grip', () => {
  test('is the centripetal force up to the friction limit, and zero in the centre', () => {
    const law = corneringGrip({ friction: 0.5, gravity: 10 });
    const at = (speed: number, x = 20) => {
      const { world, eid } = single([law], { position: { x }, velocity: { y: speed }, mass: 3 });
      return forceOn(world, eid).x;
    };
    expect(at(8)).toBeCloseTo(-3 * 3.2, 13);
    expect(at(30)).toBe(-15);
    expect(at(3, 0)).toBe(0);
  });
});

describe('plane support', () => {
  const slope = (angle: number, more = {}) =>
    planeSupport({ normal: { x: Math.sin(angle), y: Math.cos(angle) }, ...more });

  test('a block on a frictionless slope has N = mg cosθ and a = g sinθ', () => {
    const { world, eid } = single([gravity, slope(0.3)], { mass: 2 });
    const { x, y } = forceOn(world, eid);
    expect(Math.hypot(x, y)).toBeCloseTo(20 * Math.sin(0.3), 12);
    expect(x * Math.sin(0.3) + y * Math.cos(0.3)).toBeCloseTo(0, 12);
    expect(x).toBeGreaterThan(0);
  });

  test('a sliding block stops after v²/(2μg) and stays at rest', () => {
    const support = planeSupport({ kineticFriction: 0.4 });
    const { world, at, speed } = single([gravity, support], { velocity: { x: 6 } });
    run(world, 3, 1 / 240);
    // Exact except for the last step, in which the speed is less than μ g dt.
    expect(at().x).toBeCloseTo(36 / 8, 3);
    expect(speed()).toBeLessThan(1e-6);
    const rest = at().x;
    run(world, 5);
    expect(at().x).toBeCloseTo(rest, 6);
  });

  test('a ball rolls with a = g sinθ/(1 + 2/5) without slip', () => {
    const [angle, radius] = [0.2, 0.5];
    const up = { x: radius * Math.sin(angle), y: radius * Math.cos(angle) };
    const body = {
      position: up,
      mass: 2,
      inertia: 0.4 * 2 * radius ** 2,
      collider: radius,
      angularVelocity: {},
      rotation: {},
    };
    const { world, eid, speed } = single([gravity, slope(angle, { kineticFriction: 0.5 })], body);
    run(world, 2);
    expect(speed()).toBeCloseTo((10 * Math.sin(angle) * 2) / 1.4, 6);
    expect(world.components.AngularVelocity.z[eid]).toBeCloseTo(-speed() / radius, 6);
  });

  test('a sliding ball starts to roll at 5/7 of its speed', () => {
    const body = {
      position: { y: 1 },
      velocity: { x: 7 },
      mass: 3,
      inertia: 0.4 * 3,
      collider: 1,
      angularVelocity: {},
      rotation: {},
    };
    const { world, eid, going } = single([gravity, planeSupport({ kineticFriction: 0.2 })], body);
    run(world, 4, 1 / 240);
    expect(going().x).toBeCloseTo(5, 2);
    expect(world.components.AngularVelocity.z[eid]).toBeCloseTo(-going().x, 2);
  });

  test('lift unloads the wheels, and the aeroplane takes off', () => {
    const forces = [gravity, lift(), thrust(), quadraticDrag(), planeSupport({ kineticFriction: 0.1 })];
    const body = { lift: 0.025, thrust: { x: 5 }, velocity: { x: 19 } };
    const { world, eid, at } = single(forces, body);
    expect(forceOn(world, eid).x).toBeCloseTo(5 - 0.1 * (10 - 0.025 * 361), 10);
    run(world, 5);
    expect(at().y).toBeGreaterThan(0.5);
  });

  test('a body at rest does not sink by rounding, even in single precision', () => {
    // The vertical forces cancel except for a rounding of 10⁻⁶ m/s², which would add up to 0.2 m in ten minutes.
    const support = planeSupport({ kineticFriction: 0.1 });
    const body = { mass: 3, thrust: { x: 1, y: 2 } };
    const { world, at } = single([gravity, thrust(), support], body, { precision: 'f32' });
    run(world, 600);
    expect(Math.abs(at().y)).toBeLessThan(1e-4);
  });

  test('3D equals 2D, also across the slope', () => {
    const body = { velocity: { z: 3 } };
    const law = slope(0, { kineticFriction: 0.5 });
    const { world, eid } = single([gravity, law], body, { dimensions: 3 });
    expect(forceOn(world, eid)).toMatchObject({ x: 0, y: 0, z: -5 });
  });

  test('energy never increases, except in the step in which the slip reverses', () => {
    const { world } = single([gravity, slope(0.5, { kineticFriction: 0.1 })], {
      velocity: { x: -3 * Math.cos(0.5), y: 3 * Math.sin(0.5) },
    });
    let last = energy(world).total;
    run(world, 3, 1 / 60, () => {
      expect(energy(world).total).toBeLessThanOrEqual(last + 1e-3);
      last = energy(world).total;
    });
  });
});
