import { describe, expect, test } from 'vitest';
import { forceOn, read, run, single } from '../../../../test/support/laws.ts';
import {
  createPhysicsWorld,
  linearDrag,
  motors,
  PhysicsError,
  rocketEngines,
  semiImplicitEuler,
  spawn,
  step,
  thrust,
  velocityVerlet,
} from '../index.ts';

describe('rocket engines', () => {
  const engine = { exhaustSpeed: 200, burnRate: 0.5, fuel: 3.5 };

  test('Δv is v_e ln(m₀/m₁) to rounding, with every integrator and step, even if fuel ends within a step', () => {
    for (const integrator of [semiImplicitEuler, velocityVerlet]) {
      for (const dt of [1 / 60, 0.3, 10]) {
        const { world, eid, going } = single([rocketEngines()], { mass: 10, engine }, { integrator });
        run(world, 10, dt);
        expect(going().y).toBeCloseTo(200 * Math.log(10 / 6.5), 10);
        expect(world.components.Engine.fuel[eid]).toBe(0);
        expect(world.components.Mass.value[eid]).toBeCloseTo(6.5, 12);
        step(world, dt);
        expect(world.components.Engine.thrustY[eid]).toBe(0);
      }
    }
  });

  test('burn in single precision what is less than the last digit of the mass', () => {
    // A step burns 5e-7 kg; neighbours of 500 are 3e-5 apart, and those of 50 are 4e-6.
    const ion = { exhaustSpeed: 30_000, burnRate: 3e-5, fuel: 50 };
    const { world, eid, going } = single([rocketEngines()], { mass: 500, engine: ion }, { precision: 'f32' });
    const { Mass, Engine } = world.components;
    run(world, 600, 1 / 60);
    const burnt = 3e-5 * 600;
    expect(Math.abs(Engine.fuel[eid] - (50 - burnt))).toBeLessThan(2 ** -19);
    expect(Math.abs(Mass.value[eid] - (500 - burnt))).toBeLessThan(2 ** -16);
    // A step gives 3e-5 m/s, and is rounded by at most half the last digit of 1 m/s.
    const speed = 30_000 * Math.log(500 / (500 - burnt));
    expect(Math.abs(going().y - speed)).toBeLessThan(36_000 * 2 ** -24);
    // What a user writes counts, and not what was left of the number before.
    Mass.value[eid] = 2 ** -10;
    Engine.fuel[eid] = 0;
    step(world, 1 / 60);
    expect([Mass.value[eid], Engine.fuel[eid], Engine.thrustY[eid]]).toEqual([2 ** -10, 0, 0]);
  });

  test('conserve the momentum of rocket and exhaust: m dv = -v_e dm in every step', () => {
    const { world, eid, going } = single([rocketEngines()], { mass: 10, engine });
    const { Mass } = world.components;
    let [exhaust, speed, mass] = [0, 0, 10];
    for (let i = 0; i < 100; i++) {
      step(world, 1e-3);
      exhaust += (mass - Mass.value[eid]) * ((speed + going().y) / 2 - 200);
      [speed, mass] = [going().y, Mass.value[eid]];
    }
    expect(exhaust + mass * speed).toBeCloseTo(0, 6);
  });

  test('scale with the throttle and rotate with the body', () => {
    const quarter = { engine: { ...engine, throttle: 0.25 }, mass: 1e6, rotation: Math.PI / 2 };
    const { world, eid } = single([rocketEngines()], quarter);
    expect(forceOn(world, eid).x).toBeCloseTo(-25, 4);
    const half = Math.SQRT1_2;
    const turned = { engine, mass: 1e6, orientation: { x: half, w: half } };
    const solid = single([rocketEngines()], turned, { dimensions: 3 });
    expect(forceOn(solid.world, solid.eid).z).toBeCloseTo(100, 3);
    const fixed = single([rocketEngines({ frame: 'world' })], quarter);
    expect(forceOn(fixed.world, fixed.eid).y).toBeCloseTo(25, 4);
  });

  test('can be shared by two worlds, and a rocket made of fuel keeps some mass', () => {
    const law = rocketEngines();
    const a = single([law], { mass: 1, engine: { ...engine, fuel: 1 } });
    const b = single([law], { mass: 1 });
    run(a.world, 10);
    run(b.world, 10);
    expect(a.world.components.Mass.value[a.eid]).toBeGreaterThan(0);
    expect(Number.isFinite(a.speed())).toBe(true);
    expect(b.speed()).toBe(0);
    expect(() => single([law], { engine: { ...engine, y: 0 } })).toThrow(PhysicsError);
  });
});

describe('thrust', () => {
  test('is in axes of the world or of the body, and changes at run time', () => {
    const { world, eid, going } = single([thrust()], { mass: 2, thrust: { x: 4 } });
    run(world, 1);
    world.components.Thrust.x[eid] = 0;
    run(world, 1);
    expect(going().x).toBeCloseTo(2, 12);
    const turned = single([thrust({ frame: 'body' })], { thrust: { x: 4 }, rotation: Math.PI / 2 });
    expect(forceOn(turned.world, turned.eid).y).toBeCloseTo(4, 14);
    expect(() => thrust({ frame: 'sideways' as never })).toThrow(PhysicsError);
  });
});

describe('motors', () => {
  test('increase the kinetic energy at the given power; with linear drag v² tends to P/c', () => {
    const { world, speed } = single([motors()], { mass: 3, velocity: { x: 3, y: 4 }, motor: 50 });
    run(world, 10);
    expect(0.5 * 3 * speed() ** 2).toBeCloseTo(0.5 * 3 * 25 + 500, 1);
    const dragged = single([motors(), linearDrag()], { motor: { power: 50, maxForce: 20 }, linearDrag: 0.1 });
    run(dragged.world, 120);
    expect(dragged.speed()).toBeCloseTo(Math.sqrt(500), 6);
  });

  test('start from rest along the heading with at most the maximum force', () => {
    const { world, eid } = single([motors({ heading: { y: 2 } })], { motor: { power: 50, maxForce: 8 } });
    expect(forceOn(world, eid)).toMatchObject({ x: 0, y: 8 });
    const slow = single([motors()], { velocity: { x: -1 }, motor: { power: 50, maxForce: 8 } });
    expect(forceOn(slow.world, slow.eid).x).toBe(-8);
  });

  test('brake with negative power, but exert no force at rest', () => {
    const world = createPhysicsWorld({ capacity: 5, forces: [motors()] });
    const moving = spawn(world, { position: {}, velocity: { x: 10 }, mass: 1, motor: -20 });
    const still = spawn(world, { position: {}, velocity: {}, mass: 1, motor: -20 });
    expect(forceOn(world, moving).x).toBe(-2);
    step(world, 0.1);
    expect(read(world, still).speed()).toBe(0);
  });
});
