// Compares one loop for the whole step, segments around forces that are not laws, and integrators in plain TypeScript:
// all must give the same trajectories.
import { describe, expect, test } from 'vitest';
import {
  createPhysicsWorld,
  defineForce,
  defineLaw,
  type Force,
  INTEGRATORS,
  type Integrator,
  linearDrag,
  magneticField,
  type PhysicsWorld,
  quadraticDrag,
  scalar,
  spawn,
  step,
  uniformGravity,
  vec3,
  vectorOverTime,
} from '../index.ts';

const nothing = () => defineForce({ name: 'nothing', accumulate() {} });

const spring = defineLaw({
  name: 'spring',
  parameters: { k: scalar('N/m') },
  force: ({ position }, { k }) => position.mul(k).negate(),
});

const tide = defineLaw({
  name: 'tide',
  parameters: { field: vectorOverTime('m/s²') },
  acceleration: ({ time }, { field }) => field.add(vec3(time.sin(), time.mul(0.1))),
});

/** Forces of every kind: dependent on position, velocity or time, with and without proportionality to mass. */
const laws = (): Force[] => [
  uniformGravity({ x: 0.1, y: -1 }),
  spring({ k: 3 }),
  linearDrag({ x: 0.2 }),
  quadraticDrag(),
  tide({ field: (t) => ({ x: t / 10, y: 1 - t }) }),
];

function worldOf(integrator: Integrator, forces: readonly Force[], dimensions: 2 | 3): PhysicsWorld {
  const world = createPhysicsWorld({ capacity: 100, dimensions, integrator, forces });
  for (let i = 0; i < 9; i++) {
    const [a, b] = [(i * 7) % 5, (i * 3) % 4];
    const body = { mass: 1 + i / 3, charge: i - 4, linearDrag: 0.1 * a, quadraticDrag: 0.05 * b };
    const z = dimensions === 3 ? i / 5 - 1 : 0;
    spawn(world, { position: { x: a - 2, y: b - 1, z }, velocity: { x: b / 3, y: -a / 4, z: -z / 2 }, ...body });
    // Bodies that forces do not move: without mass, and without velocity.
    if (i % 4 === 0) spawn(world, { position: { x: i }, velocity: { y: 0.5 } });
    if (i % 4 === 1) spawn(world, { position: { y: i } });
  }
  return world;
}

function states({ components: { Position: p, Velocity: v }, lastId }: PhysicsWorld): number[] {
  return Array.from({ length: lastId }, (_, i) =>
    [p, v].flatMap(({ x, y, z }) => [x[i + 1], y[i + 1], z[i + 1]]),
  ).flat();
}

function expectNear(got: readonly number[], wanted: readonly number[], tolerance: number): void {
  const worst = got.reduce(
    (most, value, i) => Math.max(most, Math.abs(value - wanted[i]) / Math.max(1, Math.abs(wanted[i]))),
    0,
  );
  expect(worst).toBeLessThan(tolerance);
}

const schemes = Object.values(INTEGRATORS)
  .map(({ create }) => create())
  .filter(({ scheme }) => scheme !== undefined);

// The results are not bitwise equal. A fused loop multiplies a sum of accelerations by dt, and F by dt/m. Segments use
// one force column, for which an acceleration is multiplied by the mass and later divided by it.
describe.each([2, 3] as const)('in %i dimensions', (dimensions) => {
  test.each(schemes)('$name gives the same trajectory in one loop and in segments', (integrator) => {
    const [whole, cut] = [laws(), [...laws(), nothing()]].map((forces) => worldOf(integrator, forces, dimensions));
    const start = states(whole);
    for (let i = 0; i < 200; i++) for (const world of [whole, cut]) step(world, 0.01 + (i % 3) * 0.001);
    expectNear(states(cut), states(whole), 1e-12);
    expect(states(whole)).not.toEqual(start);
    expect([...whole.faults.faults, ...cut.faults.faults]).toEqual([]);
  });
});

test('for forces independent of mass, one loop and segments are bitwise equal', () => {
  const { create } = INTEGRATORS.velocityVerlet;
  const forces = [spring({ k: 3 }), linearDrag(), magneticField({ z: 2 })];
  const worlds = [forces, [nothing(), ...forces]].map((all) => worldOf(create(), all, 3));
  for (let i = 0; i < 200; i++) for (const world of worlds) step(world, 0.01);
  expect(states(worlds[1])).toEqual(states(worlds[0]));
});

describe('an integrator in plain TypeScript', () => {
  /** The example of docs/adding-an-integrator.md. */
  const plainEuler: Integrator = {
    name: 'explicit Euler',
    order: 1,
    symplectic: false,
    evaluations: 1,
    advance(world, ranges, dt, evaluateForces) {
      evaluateForces(world, ranges, world.time);
      const { kernels, addresses, scratch } = world;
      const { Position, Velocity, Mass } = addresses;
      for (const axis of ['x', 'y', 'z'] as const) {
        for (let r = 0; r < ranges.count; r++) {
          const [first, last] = [ranges.bounds[2 * r], ranges.bounds[2 * r + 1]];
          kernels.driftAxis(Position[axis], Velocity[axis], dt, first, last);
          kernels.kickAxis(Velocity[axis], scratch.at.force[axis], Mass.value, dt, first, last);
        }
      }
    },
  };

  test.each([2, 3] as const)('moves bodies under laws as the built-in scheme does, in %i dimensions', (dimensions) => {
    const worlds = [INTEGRATORS.explicitEuler.create(), plainEuler].map((each) => worldOf(each, laws(), dimensions));
    for (let i = 0; i < 200; i++) for (const world of worlds) step(world, 0.01);
    expectNear(states(worlds[1]), states(worlds[0]), 1e-12);
  });

  test('is used even if it also has a scheme', () => {
    let calls = 0;
    const both: Integrator = {
      ...INTEGRATORS.velocityVerlet.create(),
      advance(...args) {
        calls++;
        plainEuler.advance?.(...args);
      },
    };
    const worlds = [both, plainEuler].map((each) => worldOf(each, laws(), 2));
    for (let i = 0; i < 20; i++) for (const world of worlds) step(world, 0.01);
    expect(calls).toBe(20);
    expect(states(worlds[0])).toEqual(states(worlds[1]));
  });

  test('may evaluate the laws at any time and state', () => {
    const asked: number[] = [];
    const curious: Integrator = {
      ...plainEuler,
      advance(world, ranges, dt, evaluateForces) {
        for (const part of [0, 0.25, 1]) {
          evaluateForces(world, ranges, world.time + part * dt);
          asked.push(world.scratch.force.x[1]);
        }
      },
    };
    const law = tide({ field: (t) => ({ x: 100 * t }) });
    const world = createPhysicsWorld({ capacity: 10, integrator: curious, forces: [law] });
    spawn(world, { position: {}, velocity: {}, mass: 2 });
    step(world, 1);
    [0, 25, 100].forEach((wanted, i) => {
      expect(asked[i]).toBeCloseTo(2 * (wanted + Math.sin(wanted / 100)), 12);
    });
  });
});
