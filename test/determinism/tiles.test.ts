/** Worlds of several tiles, with holes, against dense ones: the layout of the rows must not show in any bit. */
import {
  type BodyInput,
  boxWalls,
  createPhysicsWorld,
  defineForce,
  despawn,
  type Force,
  type Integrator,
  type PhysicsWorld,
  type Precision,
  quadraticDrag,
  rungeKutta4,
  semiImplicitEuler,
  spawn,
  spawnMany,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { bodyState, steps } from '../support/worlds.ts';

/** More than two tiles of 2048 rows. */
const COUNT = 5000;

const lift: Force = defineForce({
  name: 'lift, in plain TypeScript',
  accumulate({ scratch, components: { Mass, Velocity } }, first, last) {
    for (let eid = first; eid < last; eid++) scratch.force.y[eid] += Mass.value[eid] * Velocity.x[eid];
  },
});

/** Looks at more than its own body as far as the step knows, so that the step runs over the whole span at once. */
const nonLocal: Force = { ...lift, name: 'lift, not local', local: false };

function makeWorld(precision: Precision, integrator: Integrator, force?: Force): PhysicsWorld {
  return createPhysicsWorld({
    precision,
    integrator,
    capacity: 12_000,
    arenaBytes: 0,
    forces: [uniformGravity(), quadraticDrag(), ...(force === undefined ? [] : [force])],
    walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 100, y: 100 } })],
  });
}

function bodyAt(i: number): BodyInput {
  return {
    position: { x: 1 + ((i * 37) % 98), y: 1 + ((i * 61) % 98) },
    velocity: { x: ((i * 13) % 40) - 20, y: ((i * 29) % 40) - 20 },
    mass: 1 + (i % 7),
    collider: { radius: 0.1, restitution: 0.8, friction: 0.2 },
    quadraticDrag: (i % 5) * 0.01,
  };
}

function dense(world: PhysicsWorld): number[] {
  return Array.from({ length: COUNT }, (_, i) => spawn(world, bodyAt(i)));
}

/** The same bodies on recycled ids, with others and with holes of every width between them. */
function holed(world: PhysicsWorld): number[] {
  const others = spawnMany(world, 9000, { position: { x: 50, y: 50 }, velocity: { x: 1 }, mass: 1 });
  for (const eid of others) if (eid % 3 !== 0 || (eid > 3000 && eid < 3600)) despawn(world, eid);
  const ids = Array.from({ length: COUNT }, (_, i) => spawn(world, bodyAt(i)));
  const mine = new Set(ids);
  for (const eid of others) if (eid > 300 && eid < 1500 && eid % 3 === 0 && !mine.has(eid)) despawn(world, eid);
  return ids;
}

function outcome(world: PhysicsWorld, ids: readonly number[]): string[] {
  steps(world, 40);
  expect(world.faults.faults).toEqual([]);
  return ids.map((eid) => bodyState(world, eid));
}

/** One by one, so that a difference is one line and not five thousand. */
function expectSame(found: readonly string[], expected: readonly string[]): void {
  expect(new Set(expected).size).toBeGreaterThan(COUNT / 10);
  for (let i = 0; i < COUNT; i++) if (found[i] !== expected[i]) expect(found[i]).toBe(expected[i]);
}

describe.each(['f32', 'f64'] as const)('several tiles, %s', (precision) => {
  it.each([semiImplicitEuler, velocityVerlet, rungeKutta4])('holes do not show: $name', (integrator) => {
    const [plain, churned] = [0, 1].map(() => makeWorld(precision, integrator));
    const expected = outcome(plain, dense(plain));
    const ids = holed(churned);
    expect(churned.lastId).toBeGreaterThan(COUNT);
    const found = outcome(churned, ids);
    expect(churned.ranges.count).toBeGreaterThan(1);
    expectSame(found, expected);
  });

  it('tile by tile with a force in TypeScript, and all at once, give the same bits', () => {
    const [tiled, whole] = [lift, nonLocal].map((force) => {
      const world = makeWorld(precision, velocityVerlet, force);
      return outcome(world, dense(world));
    });
    expectSame(tiled, whole);
  });
});
