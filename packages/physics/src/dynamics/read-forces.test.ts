import { expect, test } from 'vitest';
import {
  attractors,
  type BodyInput,
  box,
  createPhysicsWorld,
  electricField,
  evaluateForces,
  type Force,
  fixedCharges,
  mutualGravity,
  randomDrive,
  rigidBodies,
  spawn,
  springs,
  step,
  stringTension,
  uniformGravity,
} from '../index.ts';

const still = { velocity: {}, mass: 3 };

/** Forces, what there is beside the body, the body, and the force on it. */
const CASES: readonly (readonly [
  string,
  readonly Force[],
  readonly BodyInput[],
  BodyInput,
  readonly [number, number],
])[] = [
  ['gravity', [uniformGravity({ y: -2 })], [], { position: {}, ...still }, [0, -6]],
  ['an attractor', [attractors()], [{ position: {}, attractor: 4 }], { position: { x: 2 }, ...still }, [-3, 0]],
  [
    'a fixed charge',
    [fixedCharges(1)],
    [{ position: {}, charge: 8 }],
    { position: { x: 2 }, charge: 1, ...still },
    [2, 0],
  ],
  [
    'mutual gravity',
    [mutualGravity({ G: 1 })],
    [{ position: {}, ...still }],
    { position: { x: 3 }, ...still },
    [-1, 0],
  ],
  ['a field that changes', [electricField((t) => ({ y: t }))], [], { position: {}, charge: 2, ...still }, [0, 10]],
  [
    'a string',
    [uniformGravity({ x: 1, y: -2 }), stringTension({ length: 1 })],
    [],
    { position: { y: -1 }, ...still },
    [3, 0],
  ],
];

test.each(CASES)(
  'before the first step the force of %s is what it is in the first',
  (_, forces, others, input, [x, y]) => {
    const world = createPhysicsWorld({ forces });
    for (const other of others) spawn(world, other);
    const body = spawn(world, input);
    evaluateForces(world, world.ranges, 5);
    expect([world.scratch.force.x[body], world.scratch.force.y[body]]).toEqual([x, y]);
  },
);

test('springs and rigid bodies too', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity({ y: -2 }), springs()] });
  const a = spawn(world, { position: {}, collider: { shape: box(1, 1) } });
  const b = spawn(world, { position: { x: 3 }, mass: 2, collider: { shape: box(1, 1) } });
  spawn(world, { spring: { a, b, stiffness: 5, length: 2 } });
  evaluateForces(world, world.ranges, 0);
  expect([world.scratch.force.x[b], world.scratch.force.y[b]]).toEqual([-5, -4]);
});

test('a body that came after the last step has its force', () => {
  const world = createPhysicsWorld({ forces: [uniformGravity({ y: -2 })] });
  for (let i = 0; i < 100; i++) spawn(world, { position: {}, ...still });
  step(world, 1 / 60);
  const late = spawn(world, { position: {}, ...still });
  evaluateForces(world, world.ranges, world.time);
  expect(world.scratch.force.y[late]).toBe(-6);
});

test('to read forces moves nothing, and changes no step', () => {
  const ends = [false, true].map((reads) => {
    const world = createPhysicsWorld({ forces: [randomDrive({ spectralDensity: 1 }), uniformGravity(), springs()] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 2 });
    for (let i = 0; i < 20; i++) {
      if (reads) evaluateForces(world, world.ranges, world.time);
      step(world, 0.1);
    }
    expect(world.faults.faults).toEqual([]);
    return [world.components.Position.x[body], world.components.Position.y[body]];
  });
  expect(ends[1]).toEqual(ends[0]);
});
