import { describe, expect, test } from 'vitest';
import {
  boxWalls,
  contacts,
  createPhysicsWorld,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  spawn,
  step,
  uniformGravity,
  velocityVerlet,
  wallContacts,
} from '../index.ts';

const G = 10;
const make = (options: PhysicsWorldOptions = {}) =>
  createPhysicsWorld({
    preset: particleContacts,
    integrator: velocityVerlet,
    forces: [uniformGravity({ y: -G })],
    ...options,
  });

const ball = (world: PhysicsWorld, x: number, y: number) =>
  spawn(world, { position: { x, y }, velocity: {}, mass: 2, collider: { radius: 0.5, restitution: 0.5 } });

/** Steps until `found` lists a contact. */
function stepUntilContact(world: PhysicsWorld, found: { readonly count: number }): void {
  for (let i = 0; found.count === 0 && i < 1000; i++) step(world, 1 / 60);
  expect(found.count).toBe(1);
}

describe.each(['f32', 'f64'] as const)('the speed of approach of a contact, %s', (precision) => {
  // A fall of height h ends at √(2 g h), which velocity Verlet and the time of impact compute without error.
  const digits = precision === 'f32' ? 4 : 12;
  const fallen = Math.sqrt(2 * G * 2);

  test('of a ball that fell on a fixed one', () => {
    const world = make({ precision });
    spawn(world, { position: {}, collider: { radius: 0.5, restitution: 0.5 } });
    ball(world, 0, 3);
    const found = contacts(world);
    stepUntilContact(world, found);
    expect(found.speed[0]).toBeCloseTo(fallen, digits);
    expect(found.impulse[0]).toBeCloseTo(2 * 1.5 * fallen, digits - 1);
  });

  test.each([
    ['box', { walls: [boxWalls({ min: { y: 0 } })] }, {}],
    ['plane', {}, { planeWall: { ny: 1, offset: 0 } }],
    ['segment', {}, { segmentWall: { ax: -5, ay: 0, bx: 5, by: 0 } }],
  ])('of a ball that fell on a %s', (_name, options: PhysicsWorldOptions, wall: Parameters<typeof spawn>[1]) => {
    const world = make({ precision, ...options });
    spawn(world, wall);
    ball(world, 0, 2.5);
    const found = wallContacts(world);
    stepUntilContact(world, found);
    expect(found.speed[0]).toBeCloseTo(fallen, digits);
  });

  test('is 0 for what lies', () => {
    const world = make({ precision, walls: [boxWalls({ min: { y: 0 } })] });
    const collider = { radius: 0.5 };
    spawn(world, { position: { y: 0.5 }, velocity: {}, mass: 1, collider });
    spawn(world, { position: { y: 1.5 }, velocity: {}, mass: 1, collider });
    for (let i = 0; i < 200; i++) step(world, 1 / 60);
    expect(contacts(world).impulse[0]).toBeCloseTo(G / 60, 3);
    // Far below g dt, by which the two approach before the contact acts.
    expect(Math.abs(contacts(world).speed[0])).toBeLessThan((1e-2 * G) / 60);
    expect(wallContacts(world).count).toBeGreaterThan(0);
    for (const speed of wallContacts(world).speed.subarray(0, wallContacts(world).count)) {
      expect(Math.abs(speed)).toBeLessThan((1e-2 * G) / 60);
    }
  });

  test('is negative for what overlaps and parts', () => {
    const world = make({ precision, forces: [] });
    const collider = { radius: 0.5 };
    spawn(world, { position: {}, velocity: { x: -1 }, mass: 1, collider });
    spawn(world, { position: { x: 0.5 }, velocity: { x: 2 }, mass: 1, collider });
    step(world, 1 / 60);
    expect(contacts(world).count).toBe(1);
    expect(contacts(world).speed[0]).toBeCloseTo(-3, digits);
  });
});
