// The mass of a body that is there already.
import {
  applyImpulse,
  box,
  circle,
  createPhysicsWorld,
  isAsleep,
  PhysicsError,
  segment,
  setDensity,
  setShape,
  spawn,
  spawnCompound,
} from '@principia/physics';
import { expect, test } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

function codeOf(call: () => void): string {
  try {
    call();
  } catch (error) {
    return error instanceof PhysicsError ? error.code : String(error);
  }
  return 'none';
}

test.each([
  ['a box', { shape: box(2, 1) }],
  ['a disc', { radius: 0.5 }],
  ['a circle', { shape: circle(0.5) }],
])('%s has the mass and inertia of one that is spawned with the density', (_name, collider) => {
  const world = rigidWorld({ precision: 'f64', forces: [] });
  const motion = { velocity: { x: 1, y: 2 }, angularVelocity: 3 };
  const [light, heavy] = [7, 70].map((density) =>
    spawn(world, { position: {}, ...motion, collider: { ...collider, density } }),
  );
  setDensity(world, light, 70);
  const { Mass, Inertia, Velocity, AngularVelocity } = world.components;
  for (const column of [Mass.value, Inertia.value, Velocity.x, Velocity.y, AngularVelocity.z])
    expect(column[light]).toBe(column[heavy]);
});

test('an impulse off the centre turns it by the new inertia', () => {
  const world = rigidWorld({ forces: [] });
  const body = spawn(world, { position: {}, collider: { shape: box(1, 1), density: 10 } });
  setDensity(world, body, 100);
  applyImpulse(world, body, { y: 10 }, { x: 0.5, y: 0 });
  // r J / I with I = m (a² + b²)/12 = 100/6 kg m².
  expect(world.components.AngularVelocity.z[body]).toBeCloseTo(5 / (100 / 6), 6);
});

test('after another shape it has that of the new one', () => {
  const world = rigidWorld();
  const body = spawn(world, { position: {}, collider: { shape: box(1, 1), density: 10 } });
  setShape(world, body, box(2, 2));
  setDensity(world, body, 10);
  expect(world.components.Mass.value[body]).toBeCloseTo(40, 5);
  expect(world.components.Inertia.value[body]).toBeCloseTo((40 * 8) / 12, 4);
});

test('a compound body has that of its parts', () => {
  const world = rigidWorld();
  const parts = [0, 1].map((x) => ({ shape: box(1, 1), x, density: 1 }));
  const { body } = spawnCompound(world, { parts });
  setDensity(world, body, 5);
  expect(world.components.Mass.value[body]).toBeCloseTo(10, 5);
  // Of a plate of 2 m by 1 m.
  expect(world.components.Inertia.value[body]).toBeCloseTo((10 * 5) / 12, 5);
});

test('in three dimensions it is that of a ball, and a tensor grows with the mass', () => {
  const world = createPhysicsWorld({ dimensions: 3 });
  const ball = spawn(world, { position: {}, collider: { radius: 0.5, density: 3 } });
  setDensity(world, ball, 6);
  expect(world.components.Mass.value[ball]).toBeCloseTo(Math.PI, 5);
  expect(world.components.Inertia.value[ball]).toBeCloseTo(0.4 * Math.PI * 0.25, 5);
  const top = spawn(world, { position: {}, mass: 1, collider: 0.5, inertiaTensor: { x: 1, y: 2, z: 2.5 } });
  setDensity(world, top, 6);
  expect(world.components.InertiaTensor.y[top]).toBeCloseTo(2 * Math.PI, 5);
});

test('what does not turn stays so', () => {
  const world = rigidWorld({ forces: [] });
  const body = spawn(world, { position: {}, inertia: Infinity, collider: { shape: box(1, 1), density: 10 } });
  setDensity(world, body, 100);
  applyImpulse(world, body, { y: 10 }, { x: 0.5, y: 0 });
  run(world, 0.1);
  expect(world.components.Mass.value[body]).toBe(100);
  expect(world.components.Rotation.angle[body]).toBe(0);
});

test('what sleeps on the floor sleeps or lies there with its new mass', () => {
  const world = rigidWorld();
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(10, 1) } });
  const body = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1 } });
  run(world, 1);
  setDensity(world, body, 1000);
  run(world, 2);
  expect(isAsleep(world, body)).toBe(true);
  expect(world.components.Position.y[body]).toBeCloseTo(0.5, 2);
});

test('what cannot have one is refused', () => {
  const world = rigidWorld();
  const still = spawn(world, { position: {}, collider: { shape: box(1, 1) } });
  const point = spawn(world, { position: {}, mass: 1 });
  const line = spawn(world, { position: {}, mass: 1, collider: { shape: segment({ x: -1, y: 0 }, { x: 1, y: 0 }) } });
  const body = spawn(world, { position: {}, collider: { shape: box(1, 1), density: 1 } });
  for (const id of [still, point, line]) expect(codeOf(() => setDensity(world, id, 1))).toBe('E_RANGE');
  expect(codeOf(() => setDensity(world, body, 0))).toBe('E_RANGE');
  expect(codeOf(() => setDensity(world, body, Number.NaN))).toBe('E_NONFINITE');
  expect(codeOf(() => setDensity(world, 99, 1))).toBe('E_STALE');
  expect(world.components.Mass.value[body]).toBe(1);
});
