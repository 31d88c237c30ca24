import { describe, expect, test } from 'vitest';
import { cloud, fieldAt } from '../../../../test/support/point-clouds.ts';
import { spawn } from '../bodies/spawn.ts';
import { spawnMany } from '../bodies/spawn-many.ts';
import { angularMomentum, centreOfMass, energy, momentum } from '../diagnostics/energy.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { evaluateForces } from '../dynamics/evaluate-forces.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { MutualForce } from './mutual-force.ts';
import { mutualGravity } from './mutual-gravity.ts';

/** Returns the forces on all bodies in the present state. */
function forcesIn(world: PhysicsWorld) {
  evaluateForces(world, world.ranges, 0);
  return world.scratch.force;
}

function manyIn(force: MutualForce, count: number, options: PhysicsWorldOptions = {}) {
  const { dimensions = 3, precision = 'f64' } = options;
  const world = createPhysicsWorld({ dimensions, precision, capacity: count, forces: [force], ...options });
  const made = cloud('plummer', count, dimensions);
  const { x, y, z, mass } = made;
  spawnMany(world, count, {
    position: { x, y, ...(dimensions === 3 ? { z } : {}) },
    velocity: { x: y.map((v) => -0.3 * v), y: x.map((v) => 0.3 * v) },
    mass,
  });
  return { world, cloud: made };
}

/** Returns semi-major axis and eccentricity of the relative orbit of bodies 1 and 2. */
function orbitOf({ components: { Position: p, Velocity: v } }: PhysicsWorld, mu: number) {
  const between = (c: { x: ArrayLike<number>; y: ArrayLike<number> }) =>
    [(c.x[2] as number) - (c.x[1] as number), (c.y[2] as number) - (c.y[1] as number)] as const;
  const [x, y] = between(p);
  const [u, w] = between(v);
  const a = 1 / (2 / Math.hypot(x, y) - (u * u + w * w) / mu);
  const h = x * w - y * u;
  return { a, e: Math.sqrt(1 - (h * h) / (mu * a)) };
}

describe('two bodies', () => {
  test.each([2, 3] as const)('follow an ellipse and return after its period, in %s dimensions', (dimensions) => {
    const [mu, a, e] = [4, 1, 0.5];
    const far = a * (1 + e);
    const speed = Math.sqrt((mu * (1 - e)) / (a * (1 + e)));
    const world = createPhysicsWorld({ dimensions, integrator: rungeKutta4, forces: [mutualGravity({ G: 1 })] });
    spawn(world, { position: { x: -far / 4 }, velocity: { y: -speed / 4 }, mass: 3 });
    spawn(world, { position: { x: (far * 3) / 4 }, velocity: { y: (speed * 3) / 4 }, mass: 1 });
    const steps = 2000;
    const dt = (2 * Math.PI * Math.sqrt(a ** 3 / mu)) / steps;
    for (let i = 1; i <= steps; i++) {
      step(world, dt);
      if (i % 250 !== 0) continue;
      const orbit = orbitOf(world, mu);
      expect(orbit.a).toBeCloseTo(a, 7);
      expect(orbit.e).toBeCloseTo(e, 7);
    }
    const { Position } = world.components;
    expect(Position.x[2]).toBeCloseTo((far * 3) / 4, 6);
    expect(Position.y[2]).toBeCloseTo(0, 5);
  });

  test('of very unequal mass drift with their centre of mass, momentum exact', () => {
    const world = createPhysicsWorld({ forces: [mutualGravity({ G: 1e5 })] });
    spawn(world, { position: { x: 150, y: 200 }, velocity: { y: 150 }, mass: 1 });
    spawn(world, { position: { x: 350, y: 200 }, velocity: {}, mass: 60 });
    const { a, e } = orbitOf(world, 1e5 * 61);
    expect(a).toBeCloseTo(158.44, 2);
    expect(e).toBeCloseTo(0.2623, 4);
    for (let i = 0; i < 500; i++) step(world, 0.002);
    const { x, y } = momentum(world);
    // Speeds reach 900 m/s and 15 m/s: 1000 kicks round to 1e-11 of 900 kg m/s.
    expect(Math.abs(x)).toBeLessThan(1e-9);
    expect(Math.abs(y - 150)).toBeLessThan(1e-9);
    expect((centreOfMass(world).y - 200) / world.time).toBeCloseTo(150 / 61, 8);
  });

  test('of the law 1/r circle at a speed that does not depend on the distance', () => {
    for (const distance of [1, 10]) {
      const world = createPhysicsWorld({ forces: [mutualGravity({ G: 2, law: 'inverse-distance' })] });
      // Each of mass 1 has the acceleration G/d = v²/(d/2).
      spawn(world, { position: { x: distance / 2 }, velocity: { y: 1 }, mass: 1 });
      spawn(world, { position: { x: -distance / 2 }, velocity: { y: -1 }, mass: 1 });
      for (let i = 0; i < 1000; i++) step(world, (Math.PI * distance) / 1000);
      const { x, y } = world.components.Position;
      expect(Math.hypot(x[1] as number, y[1] as number)).toBeCloseTo(distance / 2, 4);
      expect(x[1]).toBeCloseTo(distance / 2, 2);
    }
  });

  test('with softening have the force and potential of a Plummer sphere', () => {
    const force = mutualGravity({ G: 1, softening: 3 });
    const world = createPhysicsWorld({ forces: [force] });
    spawn(world, { position: { x: 0 }, velocity: {}, mass: 2 });
    spawn(world, { position: { x: 4 }, velocity: {}, mass: 5 });
    expect(forcesIn(world).x[1]).toBeCloseTo((10 * 4) / 125, 14);
    expect(force.potential(world)).toBeCloseTo(-10 / 5, 14);
  });
});

describe('the direct sum', () => {
  const laws = [
    { dimensions: 3, law: 'inverse-square', power: 2 },
    { dimensions: 2, law: 'inverse-square', power: 2 },
    { dimensions: 2, law: 'inverse-distance', power: 1 },
  ] as const;

  test.each(laws)('is the sum over all others: $dimensions dimensions, $law', ({ dimensions, law, power }) => {
    for (const precision of ['f64', 'f32'] as const) {
      for (const count of [1, 2, 3, 5, 9, 1100]) {
        const force = mutualGravity({ G: 2, law, softening: 0.1, method: 'direct' });
        const { world, cloud: made } = manyIn(force, count, { dimensions, precision });
        const found = forcesIn(world);
        const tolerance = precision === 'f64' ? 1e-12 : 2e-5;
        for (let i = 0; i < count; i += 7) {
          const [x, y, z] = fieldAt(made, i, power, 0.1).map((a) => 2 * a * (made.mass[i] as number)) as number[];
          const size = Math.hypot(x as number, y as number, z as number) + 1e-300;
          const off = [found.x[i + 1], found.y[i + 1], found.z[i + 1]] as number[];
          const error = Math.hypot(...[x, y, z].map((v, k) => (v as number) - (off[k] as number)));
          expect(error / size).toBeLessThan(tolerance * (count > 1 ? 1 : 0) + 1e-15);
        }
      }
    }
  });

  test('conserves momentum and angular momentum to rounding, and energy to the order of the integrator', () => {
    for (const dimensions of [2, 3] as const) {
      const force = mutualGravity({ G: 1e-3, softening: 0.1, method: 'direct' });
      const { world } = manyIn(force, 300, { dimensions });
      const before = { p: momentum(world), l: angularMomentum(world), e: energy(world).total };
      for (let i = 0; i < 100; i++) step(world, 0.01);
      const [p, l] = [momentum(world), angularMomentum(world)];
      for (const axis of ['x', 'y', 'z'] as const) {
        expect(Math.abs(p[axis] - before.p[axis])).toBeLessThan(1e-12 * 300);
        expect(Math.abs(l[axis] - before.l[axis])).toBeLessThan(1e-11 * 300);
      }
      expect(Math.abs(energy(world).total / before.e - 1)).toBeLessThan(1e-5);
    }
  });

  test('is zero and finite between bodies at one place', () => {
    for (const precision of ['f32', 'f64'] as const) {
      const world = createPhysicsWorld({ precision, forces: [mutualGravity({ G: 1 })] });
      for (let i = 0; i < 5; i++) spawn(world, { position: { x: 1, y: 2 }, velocity: {}, mass: 3 });
      const { x, y } = forcesIn(world);
      expect([...x.subarray(0, 6), ...y.subarray(0, 6)]).toEqual(new Array(12).fill(0));
      step(world, 0.1);
      expect(world.faults.faults).toEqual([]);
    }
  });

  test('works in units of any scale, also in f32', () => {
    const [m, d] = [2e30, 1.5e11];
    const world = createPhysicsWorld({ precision: 'f32', forces: [mutualGravity()] });
    spawn(world, { position: { x: 0 }, velocity: {}, mass: m });
    spawn(world, { position: { x: d }, velocity: {}, mass: 6e24 });
    expect((forcesIn(world).x[1] as number) / ((6.6743e-11 * m * 6e24) / d ** 2)).toBeCloseTo(1, 5);
  });

  test('does not depend on the order of the bodies beyond rounding', () => {
    const count = 500;
    const made = cloud('uniform', count, 3);
    const forcesOf = (order: number[]) => {
      const pick = (column: Float64Array) => Float64Array.from(order, (i) => column[i] as number);
      const world = createPhysicsWorld({ dimensions: 3, forces: [mutualGravity({ G: 1 })] });
      spawnMany(world, count, {
        position: { x: pick(made.x), y: pick(made.y), z: pick(made.z) },
        velocity: {},
        mass: pick(made.mass),
      });
      const { x } = forcesIn(world);
      const byBody = new Float64Array(count);
      for (const [place, i] of order.entries()) byBody[i] = x[place + 1] as number;
      return byBody;
    };
    const ascending = Array.from({ length: count }, (_, i) => i);
    const one = forcesOf(ascending);
    const other = forcesOf(ascending.map((i) => (i * 7 + 3) % count));
    for (let i = 0; i < count; i++) expect(Math.abs((one[i] as number) / (other[i] as number) - 1)).toBeLessThan(1e-9);
  });
});

describe('test particles', () => {
  // A tree pays where sources are many: test particles alone, however many, make no pairs among each other.
  test.each([
    [1, 5000, 'direct'],
    [100, 5000, 'direct'],
    [1000, 5000, 'tree'],
    [2500, 0, 'tree'],
    [2000, 0, 'direct'],
  ] as const)('%d sources and %d test particles in f64 take the %s', (sources, tests, method) => {
    const force = mutualGravity({ G: 1e-9, softening: 0.1 });
    const world = createPhysicsWorld({ dimensions: 3, precision: 'f64', capacity: 6100, forces: [force] });
    const made = cloud('plummer', sources + tests, 3);
    const part = (first: number, count: number) => ({
      position: {
        x: made.x.slice(first, first + count),
        y: made.y.slice(first, first + count),
        z: made.z.slice(first, first + count),
      },
      velocity: {},
      mass: 1,
    });
    spawnMany(world, sources, part(0, sources));
    if (tests > 0) spawnMany(world, tests, { ...part(sources, tests), testParticle: {} });
    step(world, 1e-3);
    expect(force.report(world).method).toBe(method);
  });

  test.each(['direct', 'tree'] as const)('feel forces and exert none: %s', (method) => {
    const force = mutualGravity({ G: 1, method, relativeError: 0 });
    const world = createPhysicsWorld({ dimensions: 3, forces: [force] });
    spawn(world, { position: { x: 0 }, velocity: {}, mass: 10, testParticle: {} });
    spawn(world, { position: { x: 2 }, velocity: {}, mass: 3 });
    spawn(world, { position: { x: 3 }, velocity: {}, mass: 1, testParticle: {} });
    spawn(world, { position: { x: -1 }, velocity: {}, mass: 5 });
    const { x } = forcesIn(world);
    expect(x[1]).toBeCloseTo(10 * (3 / 4 - 5), 12);
    expect(x[2]).toBeCloseTo((-3 * 5) / 9, 12);
    expect(x[3]).toBeCloseTo(-3 - 5 / 16, 12);
    expect(x[4]).toBeCloseTo((5 * 3) / 9, 12);
    expect(force.potential(world)).toBeCloseTo(-15 / 3 - 10 * (3 / 2 + 5) - (3 + 5 / 4), 12);
  });
});

test('an evaluation is reused while no body moves', () => {
  const force = mutualGravity({ G: 1e-3, softening: 0.1 });
  const { world } = manyIn(force, 100);
  for (let i = 0; i < 10; i++) step(world, 0.01);
  expect(force.report(world).evaluations).toBe(11);
  world.components.Position.x[7] = 0.5;
  step(world, 0.01);
  expect(force.report(world).evaluations).toBe(13);
});

test('a body with non-finite values is excluded and exerts no force', () => {
  const force = mutualGravity({ G: 1e-3, softening: 0.1 });
  const { world } = manyIn(force, 20);
  world.components.Mass.value[5] = Number.NaN;
  world.components.Position.x[6] = Number.POSITIVE_INFINITY;
  step(world, 0.01);
  for (const axis of ['x', 'y', 'z'] as const) {
    expect(world.components.Position[axis].subarray(1, 21).every(Number.isFinite)).toBe(true);
  }
});

test('equal worlds are bitwise equal', () => {
  const hashes = [0, 1].map(() => {
    const { world } = manyIn(mutualGravity({ G: 1e-3, softening: 0.1 }), 200, { precision: 'f32' });
    for (let i = 0; i < 20; i++) step(world, 0.01);
    return stateHash(world);
  });
  expect(hashes[0]).toBe(hashes[1]);
});

test('rejects unsupported options', () => {
  expect(() => mutualGravity({ softening: -1 })).toThrow('E_RANGE');
  expect(() => mutualGravity({ relativeError: 2 })).toThrow('E_RANGE');
  expect(() => mutualGravity({ method: 'fmm' as 'tree' })).toThrow('E_RANGE');
  expect(() => mutualGravity({ g: 1 } as object)).toThrow('E_UNKNOWN');
  const { world } = manyIn(mutualGravity({ law: 'inverse-distance' }), 3);
  expect(() => step(world, 0.1)).toThrow('dimensions: 2');
});
