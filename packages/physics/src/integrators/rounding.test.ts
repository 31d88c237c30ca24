// Where forces cancel, the acceleration is a rounding error, and a tolerance relative to it cannot be met.
import {
  attractors,
  createPhysicsWorld,
  defineForce,
  dormandPrince,
  energy,
  type Force,
  gaussRadau,
  implicitEuler,
  mutualGravity,
  type PhysicsWorld,
  quadraticDrag,
  spawn,
  springs,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';

const PRECISIONS = ['f64', 'f32'] as const;
const EPSILON = { f64: 2 ** -52, f32: 2 ** -23 };
const g = 10;

/** Returns a world, and the largest number of force evaluations of any of `steps` steps of 1/60 s. */
function counted(
  options: Parameters<typeof createPhysicsWorld>[0],
  build: (world: PhysicsWorld) => void,
  steps: number,
) {
  let evaluations = 0;
  const count = defineForce({ name: 'count', accumulate: () => void evaluations++ });
  const forces = [...((options?.forces ?? []) as Force[]), count];
  const world = createPhysicsWorld({ capacity: 20, ...options, forces });
  build(world);
  let worst = 0;
  for (let i = 0; i < steps; i++) {
    evaluations = 0;
    step(world, 1 / 60);
    worst = Math.max(worst, evaluations);
  }
  return { world, worst, position: world.components.Position, velocity: world.components.Velocity };
}

function hang(world: PhysicsWorld, { anchor, length, damping }: { anchor: number; length: number; damping: number }) {
  const a = spawn(world, { position: { y: anchor } });
  const b = spawn(world, { position: { y: anchor - length }, mass: 1 });
  spawn(world, { spring: { a, b, stiffness: 100, length: 1, damping } });
}

describe('gaussRadau in f32', () => {
  test.each([
    [0.5, 2e-6],
    [0.95, 1e-5],
    [0.99, 3e-4],
    [0.999, 3e-3],
  ])('keeps the energy of an orbit of eccentricity %d through two close encounters', (e, tolerance) => {
    // From apocentre, in steps that are longer than the encounter.
    const forces = [attractors()];
    const world = createPhysicsWorld({ capacity: 4, precision: 'f32', integrator: gaussRadau(), forces });
    spawn(world, { position: {}, attractor: 1 });
    spawn(world, { position: { x: 1 + e }, velocity: { y: Math.sqrt((1 - e) / (1 + e)) }, mass: 1 });
    const start = energy(world).total;
    let worst = 0;
    for (let s = 0; s < 130; s++) {
      step(world, 0.1);
      worst = Math.max(worst, Math.abs(energy(world).total / start - 1));
    }
    expect(worst).toBeLessThan(tolerance);
    expect(world.faults.faults).toEqual([]);
  });
});

for (const create of [() => gaussRadau(), () => dormandPrince()]) {
  describe(create().name, () => {
    // Before, a step in these states took up to 100 000 evaluations. Thirty sub-steps of Gauss-Radau take 500.
    const MAX_EVALUATIONS = 500;

    test.each(PRECISIONS)('terminal speed, %s', (precision) => {
      const options = { precision, integrator: create(), forces: [uniformGravity({ y: -g }), quadraticDrag()] };
      const fall = (world: PhysicsWorld) => void spawn(world, { position: {}, mass: 1, quadraticDrag: 0.1 });
      const { world, worst, position, velocity } = counted(options, fall, 600);
      expect(world.faults.faults).toEqual([]);
      expect(worst).toBeLessThan(MAX_EVALUATIONS);
      // v = u tanh(g t/u), y = -u²/g ln cosh(g t/u) with u = 10 m/s: the tolerance of 600 steps, or rounding.
      const error = precision === 'f64' ? 600 * 1e-9 : 600 * EPSILON.f32;
      expect(Math.abs(velocity.y[1] + 10 * Math.tanh(10)) / 10).toBeLessThan(error);
      expect(Math.abs(position.y[1] + 10 * Math.log(Math.cosh(10))) / 100).toBeLessThan(error);
    });

    test.each(PRECISIONS)('a damped spring that comes to rest, %s', (precision) => {
      const options = { precision, integrator: create(), forces: [springs()] };
      const build = (world: PhysicsWorld) => hang(world, { anchor: 0, length: 1.1, damping: 4 });
      const { world, worst, position } = counted(options, build, 1200);
      expect(world.faults.faults).toEqual([]);
      expect(worst).toBeLessThan(MAX_EVALUATIONS);
      expect(Math.abs(position.y[2] + 1)).toBeLessThan(4 * EPSILON[precision]);
    });

    test.each(PRECISIONS)('a mass that hangs in equilibrium, here and far away, %s', (precision) => {
      for (const anchor of [0, 1 + g / 100, 1000]) {
        const options = { precision, integrator: create(), forces: [springs(), uniformGravity({ y: -g })] };
        const build = (world: PhysicsWorld) => hang(world, { anchor, length: 1 + g / 100, damping: 1 });
        const { world, worst, position } = counted(options, build, 300);
        expect(world.faults.faults).toEqual([]);
        expect(worst).toBeLessThan(MAX_EVALUATIONS);
        // Accelerations are controlled to the effect of 2ε to 4ε of the coordinates of both ends.
        const bound = 16 * EPSILON[precision] * (1 + anchor);
        expect(Math.abs(position.y[2] - anchor + 1 + g / 100)).toBeLessThan(bound);
      }
    });

    test('a star at rest in the middle of three planets', () => {
      const options = { integrator: create(), forces: [mutualGravity({ G: 1 })] };
      const build = (world: PhysicsWorld) => {
        spawn(world, { position: {}, velocity: {}, mass: 1 });
        // On the circle of radius 1 each is attracted by the star with 1, by the others with 1/√3.
        const v = Math.sqrt(1 + 1 / Math.sqrt(3));
        for (let k = 0; k < 3; k++) {
          const [c, s] = [Math.cos((2 * Math.PI * k) / 3), Math.sin((2 * Math.PI * k) / 3)];
          spawn(world, { position: { x: c, y: s }, velocity: { x: -s * v, y: c * v }, mass: 1 });
        }
      };
      const { world, worst, position } = counted(options, build, 60);
      expect(world.faults.faults).toEqual([]);
      expect(worst).toBeLessThan(MAX_EVALUATIONS);
      expect(Math.hypot(position.x[1], position.y[1])).toBeLessThan(1e-12);
      expect(Math.abs(Math.hypot(position.x[2], position.y[2]) - 1)).toBeLessThan(60e-9);
    });
  });
}

test('gaussRadau: an orbit ten thousand radii from the origin', () => {
  const world = createPhysicsWorld({ capacity: 20, integrator: gaussRadau(), forces: [mutualGravity({ G: 1 })] });
  spawn(world, { position: { x: 1e4 }, velocity: {}, mass: 1 });
  const planet = spawn(world, { position: { x: 1e4 + 1.5 }, velocity: { y: Math.sqrt(1 / 3) }, mass: 1e-9 });
  for (let i = 0; i < 10; i++) step(world, 2 * Math.PI);
  expect(world.faults.faults).toEqual([]);
  // Positions are rounded by 1e-12, and so are distances: over 10 orbits this grows to some 1e-9.
  const { Position } = world.components;
  expect(Math.hypot(Position.x[planet] - 1e4 - 1.5, Position.y[planet])).toBeLessThan(1e-7);
});

describe('implicitEuler', () => {
  test.each(PRECISIONS)('a chain that has come to rest, %s', (precision) => {
    for (const far of [0, 100]) {
      for (const stiffness of [1e3, 1e4, 1e6]) {
        const options = { precision, integrator: implicitEuler(), forces: [springs()] };
        const build = (world: PhysicsWorld) => {
          const ids = [spawn(world, { position: { x: far } })];
          for (let i = 1; i <= 5; i++) {
            ids.push(spawn(world, { position: { x: far + 1.1 * i }, mass: 1 }));
            spawn(world, { spring: { a: ids[i - 1], b: ids[i], stiffness, length: 1 } });
          }
        };
        const { world } = counted(options, build, 600);
        expect(world.faults.faults).toEqual([]);
      }
    }
  });
});

describe('dormandPrince in f32', () => {
  test.each([60, 240, 960])('keeps the energy of a round orbit to rounding, in steps of 1/%d s', (rate) => {
    const world = createPhysicsWorld({
      capacity: 4,
      precision: 'f32',
      forces: [attractors()],
      integrator: dormandPrince(),
    });
    spawn(world, { position: {}, attractor: 100 });
    spawn(world, { position: { x: 5 }, velocity: { y: Math.sqrt(20) }, mass: 1 });
    const start = energy(world).total;
    // Ten periods of 2π √(5³/100) s = 7 s. A walk of as many roundings of 6e-8 at random is 1.5e-5 with the shortest steps.
    for (let i = 0; i < 70 * rate; i++) step(world, 1 / rate);
    expect(Math.abs(energy(world).total / start - 1)).toBeLessThan(5e-5);
  });
});
