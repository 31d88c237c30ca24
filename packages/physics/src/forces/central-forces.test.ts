import { describe, expect, test } from 'vitest';
import { forceOn, lawOn, run, single, slope } from '../../../../test/support/laws.ts';
import {
  enclosedMassGravity,
  energy,
  type Force,
  lennardJones,
  PhysicsError,
  paczynskiWiita,
  powerLaw,
  rungeKutta4,
  uniformSphereGravity,
  vortex,
  yukawa,
} from '../index.ts';

const solid = { dimensions: 3 as const };

/** Every law of a centre, with a position where its force is smooth. */
const LAWS: Record<string, Force> = {
  'uniform sphere, inside': uniformSphereGravity({ mu: 7, radius: 10 }),
  'uniform sphere, outside': uniformSphereGravity({ mu: 7, radius: 1 }),
  'power 1': powerLaw({ strength: -2, exponent: 1 }),
  'power -1': powerLaw({ strength: -2, exponent: -1 }),
  'power -2': powerLaw({ strength: 3, exponent: -2 }),
  'power -3': powerLaw({ strength: 3, exponent: -3 }),
  'power 0.37': powerLaw({ strength: 3, exponent: 0.37 }),
  'within the inner radius': powerLaw({ strength: 3, exponent: -2, innerRadius: 10 }),
  'Paczyński-Wiita': paczynskiWiita({ mu: 5, horizon: 0.3 }),
  Yukawa: yukawa({ strength: -4, range: 2, couplesTo: 'Mass' }),
  'Lennard-Jones': lennardJones({ depth: 2, diameter: 1.5 }),
  'vortex, core': vortex({ strength: 2, radius: 10 }),
  'vortex, outside': vortex({ strength: 2, radius: 1 }),
  'cloud, core': enclosedMassGravity({ radii: [5, 6], masses: [3, 9], gravitationalConstant: 2 }),
  'cloud, between': enclosedMassGravity({ radii: [1, 2, 4], masses: [3, 9, 10], gravitationalConstant: 2 }),
  'cloud, outside': enclosedMassGravity({ radii: [1], masses: [3], gravitationalConstant: 2 }),
};

describe('central laws', () => {
  test.each(Object.entries(LAWS))('%s: the force is minus the gradient of the energy', (_, law) => {
    const { world, eid } = single([law], { position: { x: 1.2, y: -1.5, z: 0.7 }, mass: 3 }, solid);
    const force = forceOn(world, eid);
    const down = slope(world, eid);
    for (const axis of ['x', 'y', 'z'] as const) expect(force[axis]).toBeCloseTo(down[axis], 7);
  });

  test.each(Object.entries(LAWS))('%s: zero at r = 0, and 2D equals 3D', (_, law) => {
    expect(lawOn(law, { position: {} })).toEqual({ x: 0, y: 0, z: 0, torque: 0 });
    const [flat, space] = [
      lawOn(law, { position: { x: 1.1, y: 2 } }),
      lawOn(law, { position: { x: 1.1, y: 2 } }, solid),
    ];
    expect(flat).toEqual(space);
  });

  test('a body without mass, or a removed body, gets no force', () => {
    const { world, eid } = single([powerLaw({ strength: -1, exponent: 1 })], { position: { x: 3 } });
    world.components.Mass.value[eid] = 0;
    expect(forceOn(world, eid).x).toBe(0);
  });

  test('a moving centre moves its field and has no potential', () => {
    const law = powerLaw({ strength: -1, exponent: 1, centre: { x: 1 }, centreVelocity: { x: 2 } });
    const { world, eid } = single([law], { position: { x: 5 } });
    expect(forceOn(world, eid, 0).x).toBe(-4);
    expect(forceOn(world, eid, 2).x).toBe(0);
    expect(law.potential).toBeUndefined();
  });
});

/** Laws whose fields at a distance d have magnitude 1. */
function scaledTo(d: number): Record<string, Force> {
  const shells = { radii: [d / 3, d / 2, 1.5 * d, 1.6 * d], masses: [0.5, 1, 3, 4].map((mass) => mass * d * d) };
  return {
    'outside a sphere': uniformSphereGravity({ mu: d * d, radius: d / 3 }),
    'inside a sphere': uniformSphereGravity({ mu: d * d, radius: 3 * d }),
    'power -2': powerLaw({ strength: d * d, exponent: -2 }),
    'power 1': powerLaw({ strength: 1 / d, exponent: 1 }),
    'power 1 from an inner radius on': powerLaw({ strength: 1 / d, exponent: 1, innerRadius: d / 2 }),
    'power 1/2': powerLaw({ strength: d ** -0.5, exponent: 0.5 }),
    'Paczyński-Wiita': paczynskiWiita({ mu: d * d, horizon: d / 4 }),
    Yukawa: yukawa({ strength: d * d, range: d, couplesTo: 'Mass' }),
    'Lennard-Jones': lennardJones({ depth: d, diameter: d }),
    'core of a vortex': vortex({ strength: 1 / d, radius: 2 * d }),
    'outside a vortex': vortex({ strength: 1 / d, radius: d / 2 }),
    cloud: enclosedMassGravity({ ...shells, gravitationalConstant: 1 }),
  };
}

test.each([1e-9, 1e-3, 1, 1e6, 3e14])('single precision handles every law at %d m', (d) => {
  for (const [name, law] of Object.entries(scaledTo(d))) {
    const body = { position: { x: d, y: d / 3 }, mass: 2 };
    const [single, double] = (['f32', 'f64'] as const).map((precision) => lawOn(law, body, { precision }));
    const error = Math.hypot(single.x - double.x, single.y - double.y) / Math.hypot(double.x, double.y);
    // The steepest law, (σ/r)¹³, multiplies the rounding of 6e-8 of the distance by 13; the rest adds about 15 more.
    expect(error, name).toBeLessThan(28 * 6e-8);
  }
});

describe('gravity', () => {
  test('a tunnel through a uniform sphere has the period 2π√(R³/μ), 84 minutes for the Earth', () => {
    const [mu, radius] = [3.986e14, 6.371e6];
    const period = 2 * Math.PI * Math.sqrt(radius ** 3 / mu);
    expect(period / 60).toBeCloseTo(84.35, 1);
    for (const height of [1, 1e3, 6e6]) {
      const law = uniformSphereGravity({ mu, radius });
      const { world, at } = single([law], { position: { y: height } }, { integrator: rungeKutta4 });
      run(world, period, period / 500);
      expect(at().y / height).toBeCloseTo(1, 6);
    }
  });

  test('outer shells exert no force: a hollow sphere has a field only outside', () => {
    const law = enclosedMassGravity({ radii: [1, 2, 2.5], masses: [0, 0, 10], gravitationalConstant: 1 });
    expect(lawOn(law, { position: { x: 0.5 } }).x).toBeCloseTo(0, 15);
    expect(lawOn(law, { position: { x: 1.99 } }).x).toBe(0);
    expect(lawOn(law, { position: { x: 5 } }).x).toBeCloseTo(-10 / 25, 15);
    expect(lawOn(law, { position: { x: 2.5e9 } }).x).toBeCloseTo(-10 / 6.25e18, 30);
  });

  test('a linear profile has flat rotation: v² = G dM/dr at every radius', () => {
    const radii = Array.from({ length: 100 }, (_, i) => i + 1);
    const law = enclosedMassGravity({ radii, masses: radii.map((r) => 3 * r), gravitationalConstant: 2 });
    for (const r of [1.5, 20.25, 99]) expect(-lawOn(law, { position: { x: r } }).x * r).toBeCloseTo(6, 12);
  });

  test('Paczyński-Wiita: circular orbits are stable outside 3 r_s and unstable inside', () => {
    const [mu, horizon] = [1, 0.02];
    const nudge = (radius: number) => {
      const speed = Math.sqrt((mu * radius) / (radius - horizon) ** 2);
      const body = { position: { x: radius }, velocity: { x: -1e-4 * speed, y: speed } };
      const { world, at } = single([paczynskiWiita({ mu, horizon })], body, { integrator: rungeKutta4 });
      const period = (2 * Math.PI * radius) / speed;
      let nearest = radius;
      run(world, 20 * period, period / 400, () => {
        nearest = Math.min(nearest, Math.hypot(at().x, at().y));
      });
      return nearest / radius;
    };
    expect(nudge(3.3 * horizon)).toBeGreaterThan(0.99);
    expect(nudge(2.8 * horizon)).toBeLessThan(0.5);
  });

  test('the horizon of one solar mass is 2.95 km, and the force inside is zero', () => {
    const law = paczynskiWiita({ mu: 1.32712440018e20 });
    expect(law.parameters?.horizon.value).toBeCloseTo(2953.25, 1);
    expect(lawOn(law, { position: { x: 2953 } }).x).toBe(0);
    expect(lawOn(law, { position: { x: 2954 } }).x).toBeLessThan(0);
  });
});

describe('other powers', () => {
  test('Lennard-Jones: equilibrium at 2^(1/6) σ, and small oscillations at ω² = 72 ε/(2^(1/3) σ²)', () => {
    const law = lennardJones({ depth: 2, diameter: 1.5 });
    const rest = 2 ** (1 / 6) * 1.5;
    expect(lawOn(law, { position: { x: rest } }).x).toBeCloseTo(0, 12);
    const period = (2 * Math.PI) / Math.sqrt((72 * 2) / (2 ** (1 / 3) * 1.5 ** 2));
    const { world, at } = single([law], { position: { x: rest + 1e-4 } }, { integrator: rungeKutta4 });
    run(world, period, period / 200);
    expect((at().x - rest) / 1e-4).toBeCloseTo(1, 4);
  });

  test('Yukawa is Coulomb near the centre and negligible far away', () => {
    const law = yukawa({ strength: 3, range: 100 });
    expect(lawOn(law, { position: { x: 0.01 }, charge: 2 }).x / 6e4).toBeCloseTo(1, 6);
    expect(lawOn(law, { position: { x: 1e4 }, charge: 2 }).x).toBeLessThan(1e-40);
  });

  test('energy is conserved through a singular centre with an inner radius', () => {
    const law = powerLaw({ strength: -1000, exponent: -1, innerRadius: 5 });
    const { world } = single([law], { position: { x: 100 }, velocity: { y: 3 } }, { integrator: rungeKutta4 });
    const before = energy(world).total;
    run(world, 60, 1e-4);
    // At a crossing of the border the force jumps by 200 N, and acts up to a third of a step too long or too short,
    // 0.17 steps in the mean square: at 77 m/s this is 0.26 J of 4614, and √15 times as much in 15 crossings. The
    // phases of the crossings are random, so the bound is 4.5 standard deviations of 2.2e-4.
    expect(Math.abs(energy(world).total / before - 1)).toBeLessThan(1e-3);
  });

  test('refuse invalid options', () => {
    const refused = [
      () => uniformSphereGravity({ mu: 1, radius: 0 }),
      () => powerLaw({ strength: Number.NaN, exponent: 1 }),
      () => powerLaw({ strength: 1, exponent: 1, couplesTo: 'Lift' as never }),
      () => yukawa({ strength: 1, range: -1 }),
      () => enclosedMassGravity({ radii: [], masses: [] }),
      () => enclosedMassGravity({ radii: [2, 1], masses: [1, 2] }),
      () => enclosedMassGravity({ radii: [1, 2], masses: [2, 1] }),
      () => vortex({ strength: 1, radius: 1, center: {} } as never),
    ];
    for (const make of refused) expect(make).toThrow(PhysicsError);
  });
});
