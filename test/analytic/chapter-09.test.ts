// Circular motion.
import {
  attractors,
  constantTorque,
  corneringGrip,
  createPhysicsWorld,
  discInertia,
  discMass,
  energy,
  type Integrator,
  positionFirstEuler,
  powerLaw,
  rungeKutta4,
  spawn,
  stringTension,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { expect, test } from 'vitest';
import { forceOn, read, run, single } from '../support/laws.ts';
import { crossings, measureOrbit } from '../support/orbits.ts';

test('ch09-angular-kinematics: v = ωr = 100, T = 2π/ω, a = ω²r = 200', () => {
  const body = { position: { x: 50 }, velocity: { y: 100 } };
  const { world, eid, at } = single([stringTension({ length: 50 })], body, { integrator: rungeKutta4 });
  expect(forceOn(world, eid).x).toBe(-200);
  run(world, Math.PI, 1e-3);
  expect(at().x).toBeCloseTo(50, 8);
  expect(at().y).toBeCloseTo(0, 7);
});

test('a rim from 40 to 50 turns with I = m (40² + 50²)/2, a disc less a disc', () => {
  const [outer, inner] = [50, 40].map((radius) => ({ mass: discMass(1, radius), radius }));
  const inertia = discInertia(outer.mass, outer.radius) - discInertia(inner.mass, inner.radius);
  const mass = outer.mass - inner.mass;
  expect(inertia / (mass * (40 ** 2 + 50 ** 2))).toBeCloseTo(1 / 2, 12);
  const body = { mass, inertia, rotation: {}, angularVelocity: {} };
  const { world, eid } = single([constantTorque({ z: inertia })], body);
  run(world, 3);
  expect(world.components.AngularVelocity.z[eid]).toBeCloseTo(3, 12);
});

test('ch09-rolling-wheel: without slip the contact point is at rest, and a revolution moves it by 2πR', () => {
  for (const [factor, slip] of [
    [1, 0],
    [0.5, -25],
    [2, 50],
  ]) {
    const speed = factor * 50;
    const wheel = {
      position: { x: 100 },
      velocity: { x: speed },
      rotation: {},
      angularVelocity: { z: -1 },
      collider: 50,
    };
    const { world, eid, at, going } = single([], wheel);
    run(world, 2 * Math.PI, 0.03);
    const spin = world.components.AngularVelocity.z[eid];
    expect(going().x + spin * 50).toBeCloseTo(slip, 12);
    expect(world.components.Rotation.angle[eid]).toBeCloseTo(-2 * Math.PI, 9);
    expect(at().x - 100).toBeCloseTo(factor * 314.159, 2);
  }
});

test('ch09-satellite: a circle in 15.708 s, in step with a spinning Earth', () => {
  const circle = powerLaw({ strength: -0.16, exponent: 1, centre: { x: 400, y: 300 } });
  const world = createPhysicsWorld({ capacity: 5, forces: [circle], integrator: rungeKutta4 });
  const earth = spawn(world, { position: { x: 400, y: 300 }, rotation: {}, angularVelocity: 0.4 });
  const satellite = spawn(world, { position: { x: 600, y: 300 }, velocity: { y: 80 }, mass: 1 });
  const { at } = read(world, satellite);
  run(world, (2 * Math.PI) / 0.4, 1e-3, () => {
    const angle = Math.atan2(at().y - 300, at().x - 400) - world.components.Rotation.angle[earth];
    expect(Math.abs(Math.sin(angle))).toBeLessThan(1e-12);
  });
  expect(world.time).toBeCloseTo(15.708, 3);
  expect(at().x).toBeCloseTo(600, 9);
});

test('ch09-satellite-gravity: ω = √(GM/r³), and the geostationary radius', () => {
  const at = (r: number) => {
    const world = createPhysicsWorld({ capacity: 5, forces: [attractors()] });
    spawn(world, { position: {}, attractor: 1e6 });
    const satellite = spawn(world, { position: { x: r }, velocity: {}, mass: 1 });
    return Math.sqrt(-forceOn(world, satellite).x / r);
  };
  expect(at(200)).toBeCloseTo(0.353553, 6);
  expect(at(200)).toBeCloseTo(Math.sqrt(1e6 / 200 ** 3), 9);
  expect((2 * Math.PI) / at(200)).toBeCloseTo(17.7715, 4);
  const geostationary = (1e6 / 0.16) ** (1 / 3);
  expect(geostationary).toBeCloseTo(184.2016, 4);
  expect(at(geostationary)).toBeCloseTo(0.4, 9);
});

test('ch09-circular-orbit: periods, radius over 500 s, and the launch at 45°', () => {
  const sun = { x: 400, y: 300 };
  const orbit = (r: number, angle: number, integrator: Integrator) => {
    const world = createPhysicsWorld({ capacity: 5, forces: [attractors()], integrator });
    spawn(world, { position: sun, attractor: 1e6 });
    const speed = Math.sqrt(1e6 / r);
    const velocity = { x: speed * Math.cos(angle), y: speed * Math.sin(angle) };
    return { world, planet: spawn(world, { position: { x: 400, y: 300 - r }, velocity, mass: 1 }) };
  };
  for (const [r, period] of [
    [250, 24.8365],
    [150, 11.5429],
  ]) {
    const { world, planet } = orbit(r, 0, rungeKutta4);
    run(world, period, 1e-2);
    const { x, y } = read(world, planet).at();
    expect(Math.hypot(x - 400, y - 300 + r) / r).toBeLessThan(1e-4);
  }
  for (const [integrator, low, high] of [
    [positionFirstEuler, 249.475, 250.529],
    [velocityVerlet, 250, 250.003],
  ] as const) {
    const { world, planet } = orbit(250, 0, integrator);
    const { near, far } = measureOrbit(world, planet, sun, 500, 1 / 60);
    expect(near).toBeCloseTo(low, 2);
    expect(far).toBeCloseTo(high, 2);
  }
  const { world, planet } = orbit(250, Math.PI / 4, rungeKutta4);
  const { near, far, period } = measureOrbit(world, planet, sun, 60, 1 / 240);
  expect((near + far) / 2).toBeCloseTo(250, 2);
  expect((far - near) / (far + near)).toBeCloseTo(Math.sin(Math.PI / 4), 4);
  expect(period).toBeCloseTo(24.8365, 2);
});

test('ch09-car-bend: up to 27.386 it stays on the circle, and slides outwards at higher speed', () => {
  const grip = corneringGrip({ centre: { x: 200, y: 100 }, friction: 1, gravity: 10 });
  const car = (speed: number) => {
    const body = { position: { x: 275, y: 100 }, velocity: { y: speed }, mass: 90 };
    const { world, eid, at } = single([grip], body, { integrator: rungeKutta4 });
    return { world, eid, at, radius: () => Math.hypot(at().x - 200, at().y - 100) };
  };
  const slow = car(10);
  expect(forceOn(slow.world, slow.eid).x).toBeCloseTo(-120, 12);
  run(slow.world, 47.124);
  expect(slow.at().x).toBeCloseTo(275, 2);
  const most = car(100);
  expect(forceOn(most.world, most.eid).x).toBe(-900);
  expect(Math.sqrt(10 * 75)).toBeCloseTo(27.386, 3);
  const near = car(27);
  run(near.world, 20, 1 / 60, () => expect(Math.abs(near.radius() - 75)).toBeLessThan(0.05));
  const fast = car(28);
  run(fast.world, 20, 1 / 240);
  expect(fast.radius()).toBeCloseTo(87.7, 1);
});

test('ch09-pendulum: T = 9.04046 at 30°, v = 73.205, tension 86.60 to 126.79, length 200 for 100 s', () => {
  const pendulum = (angle: number) => {
    const pivot = { x: 350, y: 50 };
    const forces = [uniformGravity({ y: 100 }), stringTension({ pivot, length: 200 })];
    const position = { x: 350 + 200 * Math.sin(angle), y: 50 + 200 * Math.cos(angle) };
    return single(forces, { position }, { integrator: rungeKutta4 });
  };
  const { world, eid, at, speed } = pendulum(Math.PI / 6);
  const tension = () => {
    const { x, y } = forceOn(world, eid);
    return Math.hypot(x, y - 100);
  };
  expect(tension()).toBeCloseTo(86.6, 2);
  const before = energy(world).total;
  let [fastest, tightest] = [0, 0];
  run(world, 9.04046, 1 / 60, () => {
    fastest = Math.max(fastest, speed());
    tightest = Math.max(tightest, tension());
  });
  expect(at().x).toBeCloseTo(450, 3);
  expect(fastest).toBeCloseTo(73.205, 2);
  expect(tightest).toBeCloseTo(126.79, 2);
  run(world, 91, 1 / 60, () => expect(Math.abs(Math.hypot(at().x - 350, at().y - 50) - 200)).toBeLessThan(0.01));
  expect(energy(world).total / before).toBeCloseTo(1, 6);
  const small = pendulum(1e-3);
  const times = crossings(small.world, () => small.at().x, 350, 20, 1 / 240);
  expect(times[1] - times[0]).toBeCloseTo(8.88577, 4);
});
