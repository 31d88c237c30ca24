// Invalid values do not spread from body to body, and a world that is too small is refused.
import {
  box,
  contactEvents,
  createJoint,
  createPhysicsWorld,
  defineForce,
  discInertia,
  distance,
  PhysicsError,
  rigidBodies,
  rungeKutta4,
  softStep,
  spawn,
  stateHash,
  step,
  uniformGravity,
  velocityVerlet,
  xpbd,
} from '@principia/physics';
import { expect, test } from 'vitest';

const DT = 1 / 60;

/** A stack of four on the ground, joined to a fifth body. */
function stackedWorld(forces = [uniformGravity()]) {
  const world = createPhysicsWorld({ preset: rigidBodies, forces, capacity: 100, precision: 'f32' });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.6 } });
  const stack = Array.from({ length: 4 }, (_, i) =>
    spawn(world, { position: { y: 0.5 + i }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } }),
  );
  const bob = spawn(world, { position: { x: 2, y: 4 }, mass: 1, collider: { radius: 0.1 } });
  createJoint(world, distance({ a: stack[3], b: bob }));
  return { world, stack, bob };
}

test.each(['Position', 'Velocity', 'AngularVelocity', 'Mass', 'Inertia'] as const)(
  'a body whose %s is not a number keeps it to itself',
  (name) => {
    const { world, stack } = stackedWorld();
    for (let i = 0; i < 10; i++) step(world, DT);
    const columns = world.components[name] as unknown as Record<string, Float32Array>;
    for (const field of ['y', 'z', 'value']) if (field in columns) columns[field][stack[1]] = Number.NaN;
    for (let i = 0; i < 60; i++) {
      try {
        step(world, DT);
      } catch (error) {
        // A coefficient that is not a number refuses the step, and names the body.
        expect(error).toBeInstanceOf(PhysicsError);
        expect((error as PhysicsError).entity).toBe(stack[1]);
        return;
      }
    }
    const { Position, Velocity, Rotation } = world.components;
    for (let id = 1; id <= world.lastId; id++) {
      for (const value of [Position.x[id], Position.y[id], Velocity.x[id], Velocity.y[id], Rotation.angle[id]]) {
        expect(Number.isFinite(value)).toBe(true);
      }
      expect(Math.abs(Position.y[id])).toBeLessThan(10);
    }
    // Inertia that is not above 0 locks the rotation, and is no fault.
    if (name === 'Inertia') return;
    expect(world.faults.faults.some(({ entity }) => entity === stack[1])).toBe(true);
  },
);

test('a force that is not a number acts on no body', () => {
  const bad = defineForce({
    name: 'bad',
    accumulate(world) {
      world.scratch.force.x[3] = Number.NaN;
    },
  });
  const { world } = stackedWorld([uniformGravity(), bad]);
  for (let i = 0; i < 60; i++) step(world, DT);
  for (let id = 1; id <= world.lastId; id++) expect(Number.isFinite(world.components.Position.x[id])).toBe(true);
  expect(world.faults.faults.length).toBeGreaterThan(0);
});

test('masses from 1e-30 kg to 1e30 kg in one heap stay finite', () => {
  const world = createPhysicsWorld({
    preset: rigidBodies,
    forces: [uniformGravity()],
    capacity: 100,
    precision: 'f32',
  });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(100, 1), friction: 0.6 } });
  for (const [i, mass] of [1, 1e-30, 1e30, 1e-10, 1e10].entries()) {
    const inertia = discInertia(mass, 0.5);
    const turning = { rotation: 0, angularVelocity: 0, inertia };
    spawn(world, {
      position: { x: 0.01 * i, y: 0.5 + i },
      mass,
      ...turning,
      collider: { shape: box(1, 1), friction: 1 },
    });
  }
  for (let i = 0; i < 300; i++) step(world, DT);
  for (let id = 1; id <= world.lastId; id++) expect(Number.isFinite(world.components.Position.y[id])).toBe(true);
});

test('contacts for which there is no room are counted, and the world goes on', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 500, arenaBytes: 500_000, forces: [] });
  for (let i = 0; i < 400; i++) spawn(world, { position: { x: 0.001 * i }, collider: { radius: 0.5, density: 1 } });
  for (let i = 0; i < 10; i++) step(world, DT);
  expect(contactEvents(world).droppedCount).toBeGreaterThan(0);
  for (let id = 1; id <= world.lastId; id++) expect(Number.isFinite(world.components.Position.x[id])).toBe(true);
});

test('a world too small for rigid bodies, of three dimensions or with another integrator is refused', () => {
  const refused = (code: string) => expect.objectContaining({ code });
  expect(() => createPhysicsWorld({ preset: rigidBodies, arenaBytes: 1000 })).toThrow(refused('E_CAPACITY'));
  expect(() => createPhysicsWorld({ preset: rigidBodies, dimensions: 3 })).toThrow(refused('E_RANGE'));
  expect(() => createPhysicsWorld({ preset: rigidBodies, integrator: rungeKutta4 })).toThrow(refused('E_RANGE'));
  expect(() => createPhysicsWorld({ preset: rigidBodies, integrator: softStep({ substeps: 2 }) })).not.toThrow();
});

test.each([
  ['xpbd', xpbd()],
  ['velocityVerlet', velocityVerlet],
  ['rungeKutta4', rungeKutta4],
])('%s set later refuses the step, and nothing moves until a soft step is set again', (_, integrator) => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()] });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1) } });
  const crate = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 100 } });
  step(world, DT);
  const before = [world.tick, stateHash(world)];
  const own = world.integrator;
  world.integrator = integrator;
  for (let i = 0; i < 2; i++) {
    expect(() => step(world, DT)).toThrow(`E_RANGE: rigid bodies are not solved by ${integrator.name}.`);
  }
  expect([world.tick, stateHash(world)]).toEqual(before);
  for (const allowed of [own, softStep({ substeps: 8 })]) {
    world.integrator = allowed;
    for (let i = 0; i < 60; i++) step(world, DT);
  }
  // It stands within the slop of contacts.
  expect(Math.abs(world.components.Position.y[crate] - 0.5)).toBeLessThan(0.005);
});

test.each([undefined, 2 ** 24])(
  'softStep in a world without the preset is refused with its name, arenaBytes %s',
  (arenaBytes) => {
    const world = createPhysicsWorld({ integrator: softStep(), ...(arenaBytes && { arenaBytes }) });
    spawn(world, { position: {}, collider: { shape: box(1, 1), density: 1 } });
    expect(() => step(world, DT)).toThrow(/preset: rigidBodies/);
  },
);

test('a mask with a sign is refused with how to write it', () => {
  const world = createPhysicsWorld({ preset: rigidBodies });
  expect(() => spawn(world, { position: {}, collider: { radius: 1, mask: ~4 } })).toThrow(/~4 >>> 0/);
  expect(() => spawn(world, { position: {}, collider: { radius: 1, mask: ~4 >>> 0 } })).not.toThrow();
});
