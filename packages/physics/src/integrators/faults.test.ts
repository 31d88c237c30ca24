import {
  attractors,
  createPhysicsWorld,
  defineForce,
  denseInterval,
  denseState,
  dormandPrince,
  gaussRadau,
  INTEGRATORS,
  type Integrator,
  type IntegratorName,
  implicitEuler,
  linearDrag,
  mutualGravity,
  positionVerlet,
  spawn,
  springs,
  step,
  uniformGravity,
  velocityVerlet,
  wisdomHolman,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import {
  advance,
  distance,
  kepler,
  keplerExact,
  oscillator,
  stateOf,
} from '../../../../test/support/integrator-problems.ts';

const NAMES = Object.keys(INTEGRATORS) as IntegratorName[];

function expectFinite(world: ReturnType<typeof createPhysicsWorld>): void {
  const { Position, Velocity } = world.components;
  for (let eid = 1; eid <= world.lastId; eid++) {
    for (const axis of ['x', 'y', 'z'] as const) {
      expect(Number.isFinite(Position[axis][eid])).toBe(true);
      expect(Number.isFinite(Velocity[axis][eid])).toBe(true);
    }
  }
}

describe('singular configurations', () => {
  for (const name of NAMES) {
    test(`${name}: a fall through the centre, and a body in it, stay finite`, () => {
      const world = createPhysicsWorld({
        capacity: 10,
        integrator: INTEGRATORS[name].create(),
        forces: [mutualGravity({ G: 1 })],
      });
      spawn(world, { position: {}, velocity: {}, mass: 1 });
      spawn(world, { position: { x: 1 }, velocity: {}, mass: 1e-3 });
      spawn(world, { position: {}, velocity: {}, mass: 1e-3 });
      for (let i = 0; i < 40; i++) step(world, 0.05);
      expectFinite(world);
    });
  }

  const fall = (integrator: Integrator) => {
    const world = createPhysicsWorld({ capacity: 10, integrator, forces: [attractors()] });
    spawn(world, { position: {}, attractor: 1 });
    const body = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
    spawn(world, { position: { x: 3 }, velocity: { y: 0.5 }, mass: 1 });
    for (let i = 0; i < 30; i++) step(world, 0.05);
    return { world, body };
  };

  for (const create of [() => dormandPrince(), () => gaussRadau()]) {
    test(`${create().name} reports E_STEP of the falling body, and continues`, () => {
      const { world, body } = fall(create());
      const [fault] = world.faults.faults;
      expect(fault).toMatchObject({ code: 'E_STEP', entity: body, field: 'sub-step', phase: 'integrate' });
      expect(fault.value).toBeLessThan(1e-11);
      expectFinite(world);
      expect(world.time).toBeCloseTo(1.5, 12);
    });
  }

  // At the equilibrium all accelerations vanish together: error control relative to them must not stop there.
  for (const create of [() => dormandPrince(), () => gaussRadau()]) {
    test(`${create().name} starts an oscillator at its equilibrium as easily as at its turning point`, () => {
      const period = (x: number, velocity: number) => {
        const ball = oscillator(create(), 1, 0);
        const { Position, Velocity } = ball.world.components;
        [Position.x[ball.body], Velocity.x[ball.body]] = [x, velocity];
        let evaluations = 0;
        ball.world.forces.push(defineForce({ name: 'count', accumulate: () => void evaluations++ }));
        advance(ball, 2 * Math.PI, 10);
        expect(ball.world.faults.faults).toEqual([]);
        // A hundred sub-steps of 1e-9 at most.
        expect(distance(stateOf(ball), [x, 0, velocity, 0])).toBeLessThan(1e-7);
        return evaluations;
      };
      const ratio = period(0, 1) / period(1, 0);
      expect(ratio).toBeGreaterThan(0.75);
      expect(ratio).toBeLessThan(1.33);
    });
  }

  test('with onFault "throw" the step throws it', () => {
    const world = createPhysicsWorld({
      capacity: 10,
      integrator: dormandPrince(),
      forces: [attractors()],
      onFault: 'throw',
    });
    spawn(world, { position: {}, attractor: 1 });
    spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
    expect(() => step(world, 1.5)).toThrow(/E_STEP/);
  });

  test('wisdomHolman reports a body in the centre of its star', () => {
    const world = createPhysicsWorld({
      capacity: 10,
      integrator: wisdomHolman({ G: 1 }),
      forces: [mutualGravity({ G: 1 })],
    });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    const body = spawn(world, { position: {}, velocity: {}, mass: 1e-3 });
    step(world, 0.1);
    expect(world.faults.faults[0]).toMatchObject({ code: 'E_STEP', entity: body });
  });

  test.each(NAMES.flatMap((name) => [Number.NaN, Infinity, 1e308].map((bad) => [name, bad] as const)))(
    '%s: a force of %d N affects only its body',
    (name, bad) => {
      const world = createPhysicsWorld({
        capacity: 10,
        integrator: INTEGRATORS[name].create(),
        forces: [
          uniformGravity(),
          defineForce({
            name: 'nonsense',
            accumulate: ({ scratch }) => {
              scratch.force.x[1] = bad;
            },
          }),
        ],
      });
      spawn(world, { position: {}, velocity: {}, mass: 1 });
      const other = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
      step(world, 0.1);
      expect(world.faults.faults.length).toBeGreaterThan(0);
      expectFinite(world);
      step(world, 0.1);
      expectFinite(world);
      expect(world.components.Velocity.y[other]).toBeLessThan(-0.5);
      // Two kilograms a metre apart: what Wisdom-Holman's drift adds by itself.
      expect(Math.abs(world.components.Velocity.x[other])).toBeLessThan(1e-10);
    },
  );
});

describe('implicit Euler', () => {
  test('solves a stiff rope with steps fifty times too long for explicit schemes', () => {
    const world = createPhysicsWorld({
      capacity: 200,
      integrator: implicitEuler(),
      forces: [springs(), uniformGravity()],
    });
    const ids = Array.from({ length: 30 }, (_, i) =>
      spawn(world, { position: { x: i, y: 0 }, velocity: {}, ...(i === 0 ? {} : { mass: 1 }) }),
    );
    for (let i = 1; i < ids.length; i++) {
      spawn(world, { spring: { a: ids[i - 1], b: ids[i], stiffness: 1e7, damping: 10, length: 1 } });
    }
    for (let i = 0; i < 20; i++) step(world, 1 / 60);
    expect(world.faults.faults).toEqual([]);
    expectFinite(world);
    const { Position } = world.components;
    // The free end has fallen by dt² g 20 21/2, as implicit Euler falls, and the rope has not grown longer.
    expect(Position.y[ids[29]]).toBeCloseTo((-9.80665 * 210) / 3600, 6);
    expect(Math.hypot(Position.x[ids[29]], Position.y[ids[29]])).toBeLessThan(29);
  });

  test('reports E_CONVERGENCE if there is no solution', () => {
    // v' = v + 1 where v' < 0.5 and v' = v - 1 elsewhere has no solution from rest.
    const jump = defineForce({
      name: 'jump',
      accumulate({ components, scratch }) {
        scratch.force.x[1] = components.Velocity.x[1] < 0.5 ? 10 : -10;
      },
    });
    const world = createPhysicsWorld({ capacity: 10, integrator: implicitEuler(), forces: [jump] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 0.1);
    expect(world.faults.faults[0]).toMatchObject({ code: 'E_CONVERGENCE', entity: body, phase: 'integrate' });
    expectFinite(world);
    // With `onFault: 'throw'` the error contains the hint too.
    world.onFault = 'throw';
    expect(() => step(world, 0.1)).toThrow(/E_CONVERGENCE.*shorter steps/);
  });
});

describe('schemes that choose their steps', () => {
  test('the result is independent of the world’s step within the error', () => {
    for (const create of [() => dormandPrince({ tolerance: 1e-11 }), () => gaussRadau()]) {
      for (const steps of [1, 7, 1000]) {
        const planet = kepler(create(), 0.6);
        for (let i = 0; i < steps; i++) step(planet.world, 20 / steps);
        expect(distance(stateOf(planet), keplerExact(0.6, 20))).toBeLessThan(1e-7);
      }
    }
  });

  test('dormandPrince: a smaller tolerance gives a smaller error, in proportion', () => {
    const errors = [1e-5, 1e-7, 1e-9, 1e-11].map((tolerance) => {
      const planet = kepler(dormandPrince({ tolerance }), 0.5);
      for (let i = 0; i < 5; i++) step(planet.world, 4);
      return distance(stateOf(planet), keplerExact(0.5, 20));
    });
    for (let i = 1; i < errors.length; i++) {
      expect(errors[i] / errors[i - 1]).toBeLessThan(0.1);
      expect(errors[i] / errors[i - 1]).toBeGreaterThan(1e-4);
    }
  });

  test('denseState returns a body’s state within the last sub-step', () => {
    const planet = kepler(dormandPrince({ tolerance: 1e-8 }), 0.4);
    step(planet.world, 3);
    const [start, end] = denseInterval(planet.world);
    expect(end).toBe(3);
    for (const part of [0, 0.2, 0.5, 0.9, 1]) {
      const time = start + part * (end - start);
      const { position, velocity } = denseState(planet.world, planet.body, Math.min(time, end));
      const state = [position.x, position.y, velocity.x, velocity.y];
      expect(distance(state, keplerExact(0.4, time))).toBeLessThan(1e-6);
    }
    expect(() => denseState(planet.world, planet.body, 4)).toThrow(/E_RANGE/);
  });

  test('a body moved between steps continues from its new position', () => {
    for (const create of [() => dormandPrince(), () => gaussRadau(), () => positionVerlet]) {
      const ball = oscillator(create(), 1, 0);
      for (let i = 0; i < 100; i++) step(ball.world, 0.01);
      ball.world.components.Position.x[ball.body] = -2;
      ball.world.components.Velocity.x[ball.body] = 0;
      for (let i = 0; i < 100; i++) step(ball.world, 0.01);
      expect(ball.world.components.Position.x[ball.body]).toBeCloseTo(-2 * Math.cos(1), 4);
    }
  });

  test('positionVerlet: steps of changing length follow a parabola exactly', () => {
    const world = createPhysicsWorld({
      capacity: 10,
      integrator: positionVerlet,
      forces: [uniformGravity({ y: -10 })],
    });
    const ball = spawn(world, { position: {}, velocity: { y: 30 }, mass: 1 });
    for (let i = 0; i < 60; i++) step(world, 0.02 + 0.01 * (i % 3));
    const t = world.time;
    expect(world.components.Position.y[ball]).toBeCloseTo(30 * t - 5 * t * t, 10);
    expect(world.components.Velocity.y[ball]).toBeCloseTo(30 - 10 * t, 10);
  });
});

test('every integrator runs in single precision, in 3D, and does not move bodies without mass', () => {
  for (const name of NAMES) {
    const world = createPhysicsWorld({
      dimensions: 3,
      precision: 'f32',
      capacity: 10,
      integrator: INTEGRATORS[name].create(),
      forces: [attractors()],
    });
    spawn(world, { position: {}, mass: 1e10, velocity: {}, attractor: 1 });
    const planet = spawn(world, { position: { x: 1 }, velocity: { y: 0.6, z: 0.8 }, mass: 1 });
    const free = spawn(world, { position: {}, velocity: { x: 0.125 } });
    for (let i = 0; i < 100; i++) step(world, 1 / 64);
    const { Position, Velocity } = world.components;
    expect(world.faults.faults, name).toEqual([]);
    expect(Velocity.x[free], name).toBe(0.125);
    const radius = Math.hypot(Position.x[planet], Position.y[planet], Position.z[planet]);
    expect(Math.abs(radius - 1), name).toBeLessThan(0.1);
  }
});

test('a world created for another integrator reports missing capacity', () => {
  const world = createPhysicsWorld({ capacity: 100_000, arenaBytes: 0, integrator: velocityVerlet });
  spawn(world, { position: {}, velocity: {}, mass: 1 });
  world.integrator = gaussRadau();
  expect(() => step(world, 0.1)).toThrow(/E_CAPACITY.*arenaBytes/s);
  expect(world.time).toBe(0);
  world.integrator = velocityVerlet;
  step(world, 0.1);
});

test.each(['f32', 'f64'] as const)('implicit Euler: motion that decays to nothing is no fault, %s', (precision) => {
  for (const stiffness of [0, 0.1, 1e4]) {
    const options = { precision, capacity: 100, integrator: implicitEuler(), forces: [springs(), linearDrag()] };
    const world = createPhysicsWorld(options);
    const a = spawn(world, { position: { x: 1 }, velocity: { x: 1, y: 2 }, mass: 1, linearDrag: 1 });
    const b = spawn(world, { position: {} });
    if (stiffness > 0) spawn(world, { spring: { a, b, stiffness, length: 0 } });
    for (let i = 0; i < 2000; i++) step(world, 1);
    expect(world.faults.faults).toEqual([]);
    expect(Math.abs(world.components.Velocity.x[a])).toBeLessThan(1e-14);
  }
});
