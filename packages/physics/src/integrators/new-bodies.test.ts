// A body that comes after the world's first step moves as one that was there before it.
import {
  burst,
  createEmitter,
  createPhysicsWorld,
  defineIntegrator,
  despawn,
  type Force,
  INTEGRATORS,
  type Integrator,
  type IntegratorName,
  type PhysicsWorld,
  type Precision,
  select,
  spawn,
  spawnMany,
  springs,
  step,
  uniformGravity,
  vec3,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';

const DT = 0.125;
const STEPS = 8;
const G = 10;
/** From rest at the origin: the coordinates and velocities of an unused row, too. */
const AT_REST = { position: { x: 3 }, velocity: {}, mass: 1 };

/** Adams-Bashforth of order 2: the rates of this step and the last, 3/2 and -1/2; explicit Euler in a first step. */
const adamsBashforth = defineIntegrator(
  { name: 'Adams-Bashforth 2', order: 2, symplectic: false, evaluations: 1 },
  ({ position, velocity, dt, lastDt, memory: [lastKick, lastVelocity] }, kick) => {
    const kicked = kick(position, velocity, 0, dt);
    const isFirst = lastDt.equals(0);
    return {
      velocity: velocity.add(kicked.mul(1.5)).sub(select(isFirst, kicked, lastKick).mul(0.5)),
      position: position.add(
        velocity
          .mul(1.5)
          .sub(select(isFirst, velocity, lastVelocity).mul(0.5))
          .mul(dt),
      ),
      memory: [kicked, velocity],
    };
  },
  { memory: 2 },
);

/** The schemes of fixed stages. */
const SCHEMES: readonly Integrator[] = [
  ...(Object.keys(INTEGRATORS) as IntegratorName[]).map((name) => INTEGRATORS[name].create()),
  adamsBashforth,
].filter(({ scheme }) => scheme !== undefined);

const worldOf = (integrator: Integrator, forces: readonly Force[] = [], precision: Precision = 'f64') =>
  createPhysicsWorld({ capacity: 64, precision, integrator, forces: [uniformGravity({ y: -G }), ...forces] });

function advance(world: PhysicsWorld): void {
  for (let s = 0; s < STEPS; s++) step(world, DT);
}

const stateOf = ({ components: { Position, Velocity } }: PhysicsWorld, body: number) => [
  Position.x[body],
  Position.y[body],
  Velocity.x[body],
  Velocity.y[body],
];

describe.each([
  ['laws alone', () => []],
  ['a force that is a function', () => [springs()]],
] as const)('%s', (_name, forces) => {
  test.each(SCHEMES.map((scheme) => [scheme.name, scheme] as const))('%s', (_scheme, integrator) => {
    const world = worldOf(integrator, forces());
    const first = spawn(world, AT_REST);
    advance(world);
    const expected = stateOf(world, first);
    const late = spawn(world, AT_REST);
    const [among] = spawnMany(world, 1, AT_REST);
    advance(world);
    expect(stateOf(world, late)).toEqual(expected);
    expect(stateOf(world, among)).toEqual(expected);
    despawn(world, late);
    expect(spawn(world, AT_REST)).toBe(late);
    advance(world);
    expect(stateOf(world, late)).toEqual(expected);
  });
});

test.each(['f32', 'f64'] as const)('positionVerlet falls g t²/2 in %s, from the first step on', (precision) => {
  const world = worldOf(INTEGRATORS.positionVerlet.create(), [], precision);
  advance(world);
  const late = spawn(world, AT_REST);
  advance(world);
  // Every number is a multiple of 2^-8 below 2^4, so nothing is rounded.
  expect(stateOf(world, late)).toEqual([3, -G / 2, 0, -G]);
});

test.each(SCHEMES.map((scheme) => [scheme.name, scheme] as const))(
  'particles of every burst, %s',
  (_name, integrator) => {
    const world = worldOf(integrator);
    advance(world);
    const emitter = createEmitter(world, {
      capacity: 1,
      lifetime: 10,
      speed: 0,
      position: { x: 3 },
      whenFull: 'oldest',
    });
    const paths = [1, 2, 3].map(() => {
      burst(emitter, 1);
      advance(world);
      return stateOf(world, emitter.ids[0]);
    });
    const same = worldOf(integrator);
    const body = spawn(same, AT_REST);
    advance(same);
    expect(paths).toEqual([1, 2, 3].map(() => stateOf(same, body)));
  },
);

describe('the memory of an integrator', () => {
  /** Counts the steps of each body in x of its memory, and puts their number into the position. */
  const counter = defineIntegrator(
    { name: 'counter', order: 1, symplectic: false, evaluations: 0 },
    ({ velocity, memory: [count] }) => {
      const next = count.add(vec3(1, 0, 0));
      return { position: next, velocity, memory: [next] };
    },
    { memory: 1 },
  );

  test('is zero in the first step of each body, whoever had its row before', () => {
    const world = createPhysicsWorld({ capacity: 8, integrator: counter });
    const { Position } = world.components;
    const body = spawn(world, { position: {}, velocity: {}, mass: 1 });
    for (let s = 1; s <= 5; s++) {
      step(world, DT);
      expect(Position.x[body]).toBe(s);
    }
    despawn(world, body);
    for (let s = 0; s < 3; s++) step(world, DT);
    expect(spawn(world, { position: {}, velocity: {}, mass: 1 })).toBe(body);
    const fresh = spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, DT);
    expect([Position.x[body], Position.x[fresh]]).toEqual([1, 1]);
    step(world, DT);
    expect([Position.x[body], Position.x[fresh]]).toEqual([2, 2]);
  });

  test('has room in a world of any capacity', () => {
    const many = defineIntegrator(
      { name: 'ten vectors', order: 1, symplectic: false, evaluations: 0 },
      ({ position, velocity, memory }) => ({ position, velocity, memory }),
      { memory: 10 },
    );
    const world = createPhysicsWorld({ capacity: 200_000, integrator: many });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    expect(() => step(world, DT)).not.toThrow();
  });
});
