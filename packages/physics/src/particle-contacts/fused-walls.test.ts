// Box walls in the loop of the integrator give the same bits as box walls that run by themselves.
import { describe, expect, test, vi } from 'vitest';
import { steps } from '../../../../test/support/worlds.ts';
import {
  boxWalls,
  createPhysicsWorld,
  createRandom,
  despawn,
  type PhysicsWorld,
  type Preset,
  particleContacts,
  semiImplicitEuler,
  spawn,
  standard,
  stateHash,
  step,
  uniformGravity,
} from '../index.ts';

interface Case {
  readonly preset: Preset;
  readonly dimensions: 2 | 3;
  readonly precision: 'f32' | 'f64';
  readonly restitution: number;
}

/** Balls that fall into a box and press each other against its walls. */
function boxOf({ preset, dimensions, precision, restitution }: Case): PhysicsWorld {
  const world = createPhysicsWorld({
    preset,
    dimensions,
    precision,
    capacity: 200,
    forces: [uniformGravity({ y: -9.8 })],
    walls: [boxWalls({ min: { x: 0, y: 0, z: 0 }, max: { x: 5, y: 8, z: 4 }, restitution: restitution / 2 })],
  });
  const random = createRandom(7);
  const range = (min: number, max: number) => random.uniform(min, max);
  for (let i = 0; i < 150; i++) {
    const place = { x: range(0.3, 4.7), y: range(0.3, 7.7), z: dimensions === 3 ? range(0.3, 3.7) : 0 };
    const push = { x: range(-5, 5), y: range(-5, 5), z: dimensions === 3 ? range(-5, 5) : 0 };
    spawn(world, { position: place, velocity: push, mass: 1, collider: { radius: range(0.1, 0.2), restitution } });
  }
  return world;
}

const PRESETS = { standard, particleContacts };
const cases = Object.keys(PRESETS).flatMap((name) =>
  ([2, 3] as const).flatMap((dimensions) =>
    (['f32', 'f64'] as const).flatMap((precision) =>
      [0.3, 1].map((restitution) => ({ name: name as keyof typeof PRESETS, dimensions, precision, restitution })),
    ),
  ),
);

describe('walls in the loop', () => {
  test.each(cases)('$name, $dimensions D, $precision, restitution $restitution', ({ name, ...rest }) => {
    const [fused, apart] = [0, 1].map(() => boxOf({ preset: PRESETS[name], ...rest }));
    // A system between the integrator and the walls keeps them out of the loop.
    apart.phases.walls.unshift({ name: 'nothing', run() {} });
    for (const world of [fused, apart]) steps(world, 600);
    expect(fused.internal.plan?.fusion?.walls).toBeDefined();
    expect(apart.internal.plan?.fusion?.walls).toBeUndefined();
    expect(stateHash(fused)).toBe(stateHash(apart));
    expect(fused.faults.faults).toEqual([]);
  });

  test.each(['f32', 'f64'] as const)('a body with a bad velocity is alone in its fate, %s', (precision) => {
    const [fused, apart] = [0, 1].map(() =>
      boxOf({ preset: particleContacts, dimensions: 2, precision, restitution: 0.3 }),
    );
    apart.phases.walls.unshift({ name: 'nothing', run() {} });
    for (const world of [fused, apart]) {
      steps(world, 60);
      world.components.Velocity.x[7] = Number.NaN;
      world.components.Velocity.y[9] = 1e300;
      steps(world, 60);
    }
    expect(stateHash(fused)).toBe(stateHash(apart));
    expect(fused.faults.faults.map(({ entity }) => entity).sort()).toEqual([7, 9]);
  });
});

test('wall entities act from the step after they were made, and no longer than they exist', () => {
  const world = createPhysicsWorld({ preset: particleContacts, walls: [boxWalls({ min: { x: -9 } })], capacity: 64 });
  const ball = spawn(world, {
    position: { x: 0 },
    velocity: { x: -1 },
    mass: 1,
    collider: { radius: 0.1, restitution: 1 },
  });
  const { x } = world.components.Velocity;
  step(world, 0.1);
  expect(world.internal.plan?.systems.walls.map(({ name }) => name)).toEqual(['box walls']);
  const segment = spawn(world, { segmentWall: { ax: -0.5, ay: -1, bx: -0.5, by: 1 } });
  steps(world, 10, 0.1);
  expect(x[ball]).toBe(1);
  spawn(world, { planeWall: { nx: -1, ny: 0, offset: -1 } });
  steps(world, 15, 0.1);
  expect(x[ball]).toBe(-1);
  despawn(world, segment);
  steps(world, 20, 0.1);
  expect(world.components.Position.x[ball]).toBeLessThan(-0.5);
});

test('the kernel of the walls gets bodies beyond a wall, but none without a radius, and no unused rows', () => {
  const walls = boxWalls({ min: { x: 10, y: 10 }, max: { x: 20, y: 20 } });
  const bounces = vi.spyOn(walls, 'bounceListed');
  const world = createPhysicsWorld({ integrator: semiImplicitEuler, walls: [walls] });
  const balls = Array.from({ length: 32 }, (_, i) =>
    spawn(world, { position: { x: 11 + i / 4, y: 15 }, velocity: { y: 0.1 }, mass: 1, collider: 0.1 }),
  );
  spawn(world, { position: { x: 5, y: 5 }, velocity: { x: 1 }, mass: 1 });
  for (const ball of balls.filter((_, i) => i % 2 === 0)) despawn(world, ball);
  for (let i = 0; i < 10; i++) step(world, 0.01);
  expect(bounces).not.toHaveBeenCalled();
  world.components.Velocity.y[balls[1]] = 1000;
  step(world, 0.01);
  expect(bounces).toHaveBeenCalledTimes(1);
  expect(world.components.Position.y[balls[1]]).toBeLessThanOrEqual(19.9);
});
