import {
  axial3,
  boris,
  createPhysicsWorld,
  energy,
  INTEGRATORS,
  type IntegratorName,
  mutualGravity,
  type ScalarSymbol,
  spawn,
  step,
  type VectorSymbol,
  vec3,
  wisdomHolman,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { advance, distance, kepler, stateOf } from '../../../../test/support/integrator-problems.ts';

const NAMES = Object.keys(INTEGRATORS) as IntegratorName[];
const withoutPlanets = NAMES.filter((name) => name !== 'wisdomHolman');

/** Returns the largest relative energy error in each tenth of 200 orbits of eccentricity 0.2, 60 steps per orbit. */
function energyErrors(name: IntegratorName): number[] {
  const planet = kepler(INTEGRATORS[name].create(), 0.2);
  const start = energy(planet.world).total;
  return Array.from({ length: 10 }, () => {
    let worst = 0;
    for (let i = 0; i < 1200; i++) {
      step(planet.world, (2 * Math.PI) / 60);
      worst = Math.max(worst, Math.abs(energy(planet.world).total / start - 1));
    }
    return worst;
  });
}

describe('energy over 200 orbits', () => {
  for (const name of withoutPlanets.filter((candidate) => INTEGRATORS[candidate].symplectic)) {
    test(`${name}: bounded`, () => {
      const errors = energyErrors(name);
      expect(errors[9]).toBeLessThan(1.1 * errors[0]);
    });
  }

  test('rungeKutta4: grows with time', () => {
    const errors = energyErrors('rungeKutta4');
    expect(errors[9] / errors[0]).toBeGreaterThan(8);
  });

  test('dormandPrince: 1e-9 a sub-step; gaussRadau: rounding', () => {
    expect(energyErrors('dormandPrince')[9]).toBeLessThan(3e-6);
    expect(energyErrors('gaussRadau')[9]).toBeLessThan(2e-14);
  });
});

/** Returns the distance of a planet from its start after 500 steps, a reversal, and 500 steps back. */
function missAfterReturn(name: IntegratorName): number {
  const planet = kepler(INTEGRATORS[name].create(), 0.3);
  const start = stateOf(planet);
  const { Velocity } = planet.world.components;
  for (let leg = 0; leg < 2; leg++) {
    advance(planet, 25, 500);
    Velocity.x[planet.body] *= -1;
    Velocity.y[planet.body] *= -1;
  }
  return distance(stateOf(planet), start);
}

describe('a reversed run', () => {
  for (const name of withoutPlanets.filter((candidate) => INTEGRATORS[candidate].reversible)) {
    test(`${name} returns`, () => expect(missAfterReturn(name)).toBeLessThan(1e-10));
  }

  for (const name of ['explicitEuler', 'implicitEuler', 'semiImplicitEuler', 'positionFirstEuler', 'heun'] as const) {
    test(`${name} does not`, () => expect(missAfterReturn(name)).toBeGreaterThan(1e-3));
  }
});

describe('in a magnetic field', () => {
  test.each([
    ['a vector', { field: { z: 0.5 } }],
    ['an expression', { fieldAt: () => vec3(0, 0, 0.5) }],
  ])(
    'ch10-magnetic-lorentz: of %s the speed stays to 1e-12, on a circle of 80 about (350, 370) in 12.5664 s',
    (_, options) => {
      const world = createPhysicsWorld({ capacity: 10, integrator: boris(options) });
      const charge = spawn(world, { position: { x: 350, y: 450 }, velocity: { x: 40 }, mass: 1, charge: 1 });
      const { Position, Velocity } = world.components;
      let [speed, radius] = [0, 0];
      for (let i = 0; i < 6000; i++) {
        step(world, 1 / 60);
        speed = Math.max(speed, Math.abs(Math.hypot(Velocity.x[charge], Velocity.y[charge]) / 40 - 1));
        radius = Math.max(radius, Math.abs(Math.hypot(Position.x[charge] - 350, Position.y[charge] - 370) - 80));
      }
      expect(speed).toBeLessThan(1e-12);
      // The radius of Boris's circle is larger by (q B dt/m)²/8, and its centre off by as much.
      expect(radius).toBeLessThan(2 * 80 * ((0.5 / 60) ** 2 / 8) + 1e-9);
      // After 100 s: an angle of 50 rad, less Boris's lag of (q B dt/m)²/12 of it.
      const angle = 50 * (1 - (0.5 / 60) ** 2 / 12);
      expect(Position.x[charge]).toBeCloseTo(350 + 80 * Math.sin(angle), 2);
      expect(Position.y[charge]).toBeCloseTo(370 + 80 * Math.cos(angle), 2);
    },
  );

  test('in 3D, in a field that depends on position and time, the speed is constant', () => {
    for (const options of [
      { field: { x: 1, y: -2, z: 0.5 } },
      { field: (time: number) => ({ x: time, z: 3 }) },
      {
        fieldAt: ({ x, y }: VectorSymbol, time: ScalarSymbol) => axial3(y, 0, x.square().add(1).add(time)),
      },
    ]) {
      const world = createPhysicsWorld({ dimensions: 3, capacity: 10, integrator: boris(options) });
      spawn(world, { position: { x: 5 }, velocity: { y: 1 }, mass: 1 });
      const charge = spawn(world, { position: {}, velocity: { x: 1, y: 2, z: 3 }, mass: 2, charge: -3 });
      const { Velocity, Position } = world.components;
      for (let i = 0; i < 1000; i++) step(world, 0.05);
      const speed = Math.hypot(Velocity.x[charge], Velocity.y[charge], Velocity.z[charge]);
      expect(Math.abs(speed / Math.sqrt(14) - 1)).toBeLessThan(1e-12);
      expect(Position.y[1]).toBeCloseTo(50, 9);
    }
  });
});

describe('planets', () => {
  const G = 1;
  /** A star, two planets and a test particle. */
  function system(dt: number) {
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 10,
      integrator: wisdomHolman({ G }),
      forces: [mutualGravity({ G })],
    });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    spawn(world, { position: { x: 1 }, velocity: { y: 1, z: 0.05 }, mass: 1e-3 });
    const outer = spawn(world, { position: { x: -2.2 }, velocity: { y: -0.7 }, mass: 5e-4 });
    spawn(world, { position: { y: 3.5 }, velocity: { x: -0.55 }, mass: 1e-12 });
    return { world, body: outer, run: (time: number) => advance({ world, body: outer }, time, Math.round(time / dt)) };
  }

  test('wisdomHolman: second order', () => {
    const at = (dt: number) => {
      const planets = system(dt);
      planets.run(20);
      return stateOf(planets);
    };
    const reference = at(0.002);
    const errors = [0.1, 0.05, 0.025].map((dt) => distance(at(dt), reference));
    for (const i of [0, 1]) expect(Math.abs(Math.log2(errors[i] / errors[i + 1]) - 2)).toBeLessThan(0.1);
  });

  test('wisdomHolman: energy errors of a thousandth of leapfrog’s, bounded over 1000 orbits', () => {
    const planets = system(0.2);
    const start = energy(planets.world).total;
    const worst = Array.from({ length: 10 }, () => {
      let most = 0;
      for (let i = 0; i < 314; i++) {
        planets.run(2);
        most = Math.max(most, Math.abs(energy(planets.world).total / start - 1));
      }
      return most;
    });
    expect(worst[0]).toBeLessThan(2e-6);
    expect(worst[9]).toBeLessThan(1.3 * worst[0]);
  });

  test('wisdomHolman: a reversed run returns', () => {
    const planets = system(0.1);
    const start = stateOf(planets);
    const { Velocity } = planets.world.components;
    for (let leg = 0; leg < 2; leg++) {
      planets.run(50);
      for (let i = 1; i <= 4; i++) for (const axis of ['x', 'y', 'z'] as const) Velocity[axis][i] *= -1;
    }
    expect(distance(stateOf(planets), start)).toBeLessThan(1e-10);
  });

  test('wisdomHolman: a single planet or comet moves exactly on its orbit at any step', () => {
    for (const speed of [0.5, 1, 1.3, Math.SQRT2, 1.8]) {
      const path = (integrator = wisdomHolman({ G })) => {
        const world = createPhysicsWorld({ capacity: 5, integrator, forces: [mutualGravity({ G })] });
        spawn(world, { position: {}, velocity: {}, mass: 1 });
        const body = spawn(world, { position: { x: 1 }, velocity: { y: speed }, mass: 1e-15 });
        return { world, body };
      };
      const one = path();
      advance(one, 7, 2);
      const exact = path(INTEGRATORS.gaussRadau.create());
      advance(exact, 7, 10);
      expect(distance(stateOf(one), stateOf(exact))).toBeLessThan(1e-12);
    }
  });
});
