// Waves on deep water: what floats rides on them, what is as dense as the water goes round with it.
import { describe, expect, test } from 'vitest';
import { run, single } from '../../../../test/support/laws.ts';
import {
  addedMass,
  box,
  buoyancy,
  createPhysicsWorld,
  evaluateForces,
  immersedDrag,
  polygonBuoyancy,
  rigidBodies,
  rungeKutta4,
  spawn,
  surfaceHeight,
  uniformGravity,
} from '../index.ts';

const G = 9.80665;
/** Steepness a k = 0.03: the linear theory is exact to that part. */
const [amplitude, length] = [0.1, 20];
const k = (2 * Math.PI) / length;
const omega = Math.sqrt(G * k);
const period = (2 * Math.PI) / omega;
const steepness = amplitude * k;
const waves = { amplitude, length };
const sea = { density: 1000, level: 0, waves };

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  test.each([-0.5, -3, -10])('what is as dense as the water goes with it, at %d m', (depth) => {
    // Under a crest.
    const velocity = { x: amplitude * omega * Math.exp(k * depth) };
    const body = { position: { y: depth }, velocity, mass: 1000, hull: { volume: 1, halfHeight: 0.1 } };
    const forces = [uniformGravity(), buoyancy(sea)];
    const { world, eid } = single(forces, body, { precision, integrator: rungeKutta4 });
    const { Position, Velocity } = world.components;
    let [error, lowest] = [0, depth];
    run(world, 2 * period, period / 400, () => {
      const angle = k * Position.x[eid] - omega * world.time;
      const speed = amplitude * omega * Math.exp(k * Position.y[eid]);
      const [u, w] = [speed * Math.cos(angle), speed * Math.sin(angle)];
      error = Math.max(error, Math.hypot(Velocity.x[eid] - u, Velocity.y[eid] - w));
      lowest = Math.min(lowest, Position.y[eid]);
    });
    // In f32 gravity and lift cancel to 2⁻²⁴ g in each step, in 8 s.
    expect(error).toBeLessThan(precision === 'f32' ? 1e-5 : 1e-9);
    // On a circle of a e^(k z), but for a k of that.
    const radius = amplitude * Math.exp(k * depth);
    expect(Math.abs((depth - lowest) / (2 * radius) - 1)).toBeLessThan(2 * steepness);
  });

  test('a light ball rides up and down with the surface', () => {
    const [radius, mass] = [0.05, 0.1];
    const volume = (4 / 3) * Math.PI * radius ** 3;
    const forces = [uniformGravity(), buoyancy(sea), immersedDrag(sea)];
    const body = { position: { y: amplitude }, mass, linearDrag: 5 * mass, hull: { volume, halfHeight: radius } };
    const { world, eid } = single(forces, body, { precision, integrator: rungeKutta4 });
    const { Position } = world.components;
    let [error, low, high] = [0, 0, 0];
    run(world, 3 * period, period / 2000, () => {
      if (world.time < period) return;
      const height = surfaceHeight(sea, { x: Position.x[eid] }, world.time);
      [low, high] = [Math.min(low, height), Math.max(high, height)];
      error = Math.max(error, Math.abs(Position.y[eid] - height));
    });
    // It goes through troughs and crests, and stays within its draft of the surface.
    expect(low).toBeLessThan(-0.9 * amplitude);
    expect(high).toBeGreaterThan(0.9 * amplitude);
    expect(error).toBeLessThan(radius);
  });
});

test('waves of no height are a level surface, for all forces of a fluid', () => {
  const calm = { density: 1000, level: 0, flow: { x: 1 } };
  const flat = { ...calm, waves: { amplitude: 0, length } };
  const vertices = [
    { x: -1, y: -0.5 },
    { x: 1, y: -0.5 },
    { x: 1, y: 0.5 },
    { x: -1, y: 0.5 },
  ];
  const forcesOn = (fluid: typeof calm) => {
    const forces = [
      uniformGravity(),
      buoyancy(fluid),
      polygonBuoyancy(fluid, { shape: 2, vertices }),
      immersedDrag(fluid),
      addedMass(fluid),
    ];
    const world = createPhysicsWorld({ precision: 'f64', forces });
    const more = {
      velocity: { x: 2, y: -1 },
      mass: 500,
      linearDrag: 10,
      inertia: 100,
      rotation: 0.3,
      angularVelocity: 0,
    };
    const bodies = [0, 1, 2].map((shape) =>
      spawn(world, { ...more, position: { x: 3 * shape, y: 0.1 }, hull: { volume: 2, halfHeight: 0.5, shape } }),
    );
    evaluateForces(world, world.ranges, 0);
    const { force, torque } = world.scratch;
    return bodies.map((body) => [force.x[body], force.y[body], torque.z[body]]);
  };
  const [level, wavy] = [forcesOn(calm), forcesOn(flat)];
  level.forEach((values, i) => {
    values.forEach((value, j) => void expect(wavy[i][j]).toBeCloseTo(value, 8));
  });
});

test('a plank that lies along the surface of a wave is not turned, and one that lies level is turned along it', () => {
  const [width, height] = [0.5, 0.1];
  const vertices = box(width, height);
  const torqueAt = (x: number, aligned: boolean) => {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      precision: 'f64',
      forces: [polygonBuoyancy(sea, { shape: 2, vertices })],
    });
    const slope = -amplitude * k * Math.sin(k * x);
    const position = { x, y: amplitude * Math.cos(k * x) };
    const hull = { volume: width * height, shape: 2 };
    const plank = spawn(world, {
      position,
      rotation: aligned ? Math.atan(slope) : 0,
      collider: { shape: vertices, density: 500 },
      hull,
    });
    evaluateForces(world, world.ranges, 0);
    return world.scratch.torque.z[plank];
  };
  for (const x of [3, 5, 8, 12, 17]) {
    const level = torqueAt(x, false);
    // ρ g sin α times the second moment of the waterline, less that of the buoyancy: it turns the plank along the slope.
    expect(Math.sign(level)).toBe(-Math.sign(Math.sin(k * x)));
    // The pressure is steeper than the surface by a k, in the linear theory.
    expect(Math.abs(torqueAt(x, true))).toBeLessThan(2 * steepness * Math.abs(level));
  }
});

test('waves travel by a length in a period √(2π length / g), in their direction', () => {
  const swell = {
    density: 1000,
    level: 2,
    waves: { amplitude: 0.5, length: 50, direction: { x: 3, z: 4 }, phase: 0.7 },
  };
  const speed = Math.sqrt((G * 50) / (2 * Math.PI));
  for (const time of [0, 1.3, 20]) {
    const at = { x: 1 + 0.6 * speed * time, y: 7, z: -2 + 0.8 * speed * time };
    expect(surfaceHeight(swell, at, time)).toBeCloseTo(surfaceHeight(swell, { x: 1, z: -2 }, 0), 9);
  }
  expect(surfaceHeight(swell, {}, 0)).toBeCloseTo(2 + 0.5 * Math.cos(0.7), 12);
  expect(surfaceHeight({ density: 1, level: 3 }, {}, 5)).toBe(3);
});

test('a ball of the density of water goes round in the plane of waves that go at a slant in 3D', () => {
  const swell = { density: 1000, level: 0, waves: { ...waves, direction: { x: 3, z: -4 } } };
  const speed = amplitude * omega * Math.exp(-2 * k);
  const velocity = { x: 0.6 * speed, z: -0.8 * speed };
  const body = { position: { y: -2 }, velocity, mass: 1000, hull: { volume: 1, halfHeight: 0.1 } };
  const forces = [uniformGravity(), buoyancy(swell)];
  const { world, going, at } = single(forces, body, { dimensions: 3, integrator: rungeKutta4 });
  run(world, 0.3 * period, period / 400);
  const { x, y, z } = at();
  const angle = k * (0.6 * x - 0.8 * z) - omega * world.time;
  const there = amplitude * omega * Math.exp(k * y);
  expect(going().x).toBeCloseTo(0.6 * there * Math.cos(angle), 9);
  expect(going().y).toBeCloseTo(there * Math.sin(angle), 9);
  expect(0.8 * x + 0.6 * z).toBeCloseTo(0, 12);
});

test('what it weighs itself, added mass included, goes with the water all the same', () => {
  const radius = amplitude * Math.exp(-2 * k);
  const body = {
    position: { y: -2 },
    velocity: { x: omega * radius },
    mass: 1000,
    hull: { volume: 1, halfHeight: 0.1 },
  };
  const path = (more: ReturnType<typeof addedMass>[]) => {
    const { world, at } = single([uniformGravity(), buoyancy(sea), ...more], body, { integrator: rungeKutta4 });
    run(world, period, period / 400);
    return at();
  };
  const [without, withIt] = [path([]), path([addedMass(sea)])];
  expect(withIt.x).toBeCloseTo(without.x, 12);
  expect(withIt.y).toBeCloseTo(without.y, 12);
});

test.each([
  ['without a level', { density: 1000, waves }, /need a surface.*level/s],
  ['that break', { ...sea, waves: { amplitude: 2, length: 20 } }, /break.*1\.43 m/s],
  ['that go up', { ...sea, waves: { ...waves, direction: { y: 1 } } }, /no direction/],
  ['with unknown options', { ...sea, waves: { ...waves, period: 3 } as never }, /period/],
  ['of no length', { ...sea, waves: { amplitude: 0, length: 0 } }, /length/],
])('waves %s are refused', (_, fluid, message) => {
  expect(() => buoyancy(fluid)).toThrow(message);
});
