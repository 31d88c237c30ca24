import { describe, expect, test } from 'vitest';
import { cloud } from '../../../../test/support/point-clouds.ts';
import type { BodyInput } from '../bodies/body-input.ts';
import { spawn } from '../bodies/spawn.ts';
import { spawnMany } from '../bodies/spawn-many.ts';
import { box } from '../collision/shapes/2d/box.ts';
import { angularMomentum, centreOfMass, energy, momentum, totalMass } from '../diagnostics/energy.ts';
import { isBody } from '../ecs/entity-ref.ts';
import { bodies } from '../ecs/ranges.ts';
import { particleContacts } from '../presets/particle-contacts.ts';
import { rigidBodies } from '../presets/rigid-bodies.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { mergeOnContact, mergers } from './merge-on-contact.ts';
import { mutualGravity } from './mutual-gravity.ts';

function mergingWorld(options: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 2000, arenaBytes: 2 ** 23, ...options });
  world.phases.collide.push(mergeOnContact);
  return world;
}

describe('touching bodies merge', () => {
  test.each([
    [2, Math.SQRT2],
    [3, 2 ** (1 / 3)],
  ] as const)('in %iD: mass, momentum, centre and size; the lower id of equals survives', (dimensions, size) => {
    const world = mergingWorld({ dimensions });
    const a = spawn(world, { position: { x: 0 }, velocity: { x: 1, y: 2 }, mass: 3, collider: 1 });
    const b = spawn(world, { position: { x: 2.5 }, velocity: { x: -3 }, mass: 3, collider: 1 });
    step(world, 0.01);
    expect(mergers(world)).toMatchObject({ total: 0, lastStep: 0 });
    for (let i = 0; i < 20; i++) step(world, 0.01);
    expect(mergers(world).total).toBe(1);
    expect(bodies(world).count).toBe(1);
    const { Mass, Velocity, Position, Collider } = world.components;
    expect(Mass.value[a]).toBe(6);
    expect(Mass.value[b]).toBe(0);
    expect([Velocity.x[a], Velocity.y[a]]).toEqual([-1, 1]);
    expect(Position.x[a]).toBeCloseTo(1.25 - world.time, 12);
    expect(Position.y[a]).toBeCloseTo(world.time, 12);
    expect(Collider.radius[a]).toBeCloseTo(size, 12);
  });

  test('charge is kept where the survivor has any', () => {
    const world = mergingWorld();
    const a = spawn(world, { position: {}, mass: 2, collider: 1, charge: 2 });
    spawn(world, { position: { x: 1 }, mass: 1, collider: 1, charge: -5 });
    const neutral = spawn(world, { position: { x: 10 }, mass: 2, collider: 1 });
    spawn(world, { position: { x: 11 }, mass: 1, collider: 1, charge: 3 });
    step(world, 0.01);
    expect(mergers(world).total).toBe(2);
    expect(world.components.Charge.value[a]).toBe(-3);
    expect(world.components.Charge.value[neutral]).toBe(0);
  });

  test('the heavier body survives, and immovable bodies do not merge', () => {
    const world = mergingWorld();
    spawn(world, { position: { x: 0 }, mass: 1, collider: 1 });
    const heavy = spawn(world, { position: { x: 1 }, mass: 9, collider: 1 });
    spawn(world, { position: { x: 10 }, collider: 1 });
    spawn(world, { position: { x: 10.5 }, mass: 1, collider: 1 });
    step(world, 0.01);
    expect(bodies(world).count).toBe(3);
    expect(world.components.Mass.value[heavy]).toBe(10);
    expect(world.components.Position.x[heavy]).toBeCloseTo(0.9, 12);
  });

  test('a chain merges until no bodies overlap', () => {
    const world = mergingWorld({ dimensions: 3 });
    for (let i = 0; i < 10; i++) spawn(world, { position: { x: 1.5 * i }, mass: 1 + i, collider: 1 });
    step(world, 0.01);
    for (let i = 0; i < 5; i++) step(world, 0.01);
    const { ids, count } = bodies(world);
    expect(count).toBeLessThan(5);
    const { Position, Collider } = world.components;
    for (let i = 1; i < count; i++) {
      const [a, b] = [ids[i - 1], ids[i]];
      expect(Position.x[b] - Position.x[a]).toBeGreaterThan(Collider.radius[a] + Collider.radius[b]);
    }
    expect(totalMass(world)).toBe(55);
    expect(centreOfMass(world).x).toBeCloseTo((1.5 * 330) / 55, 12);
    expect(mergers(world).total).toBe(10 - bodies(world).count);
  });

  test.each(['before', 'after'] as const)('%s the collisions of particleContacts', (place) => {
    for (const restitution of [0, 1]) {
      const world = createPhysicsWorld({ preset: particleContacts });
      const { collide } = world.phases;
      place === 'before' ? collide.unshift(mergeOnContact) : collide.push(mergeOnContact);
      const collider = { radius: 0.5, restitution };
      spawn(world, { position: {}, velocity: { x: 1 }, mass: 2, collider });
      spawn(world, { position: { x: 1.2, y: 0.3 }, velocity: { x: -1 }, mass: 1, collider });
      // A body that meets neither.
      spawn(world, { position: { y: 10 }, velocity: { x: 1 }, mass: 1, collider });
      for (let i = 0; i < 60; i++) step(world, 1 / 60);
      expect(mergers(world).total).toBe(1);
      const [first] = bodies(world).ids;
      const { Position, Velocity } = world.components;
      expect(Velocity.x[first]).toBeCloseTo(1 / 3, 12);
      // The momentum across, which the impulse between the two exchanged, and their centre.
      expect(Velocity.y[first]).toBeCloseTo(0, 12);
      expect(Position.x[first]).toBeCloseTo(1.2 / 3 + 1 / 3, 12);
      expect(Position.y[first]).toBeCloseTo(0.1, 12);
    }
  });

  test('orbital angular momentum becomes spin', () => {
    const world = mergingWorld();
    const ball = { mass: 1, collider: 1, inertia: 0.5, angularVelocity: { z: 0 }, rotation: {} };
    spawn(world, { ...ball, position: { x: -2, y: 0.5 }, velocity: { x: 1 } });
    spawn(world, { ...ball, position: { x: 2, y: -0.5 }, velocity: { x: -1 }, angularVelocity: { z: 3 } });
    const before = angularMomentum(world).z;
    for (let i = 0; i < 300; i++) step(world, 0.01);
    expect(bodies(world).count).toBe(1);
    expect(angularMomentum(world).z).toBeCloseTo(before, 12);
  });

  test('a collapsing cloud conserves mass, momentum and centre, and loses energy', () => {
    const count = 600;
    const world = mergingWorld({
      dimensions: 3,
      capacity: count,
      forces: [mutualGravity({ G: 1e-3, softening: 0.02 })],
    });
    const { x, y, z, mass } = cloud('uniform', count, 3);
    spawnMany(world, count, { position: { x, y, z }, velocity: {}, mass, collider: 0.03 });
    const before = { mass: totalMass(world), centre: centreOfMass(world), energy: energy(world).total };
    for (let i = 0; i < 150; i++) step(world, 0.01);
    expect(mergers(world).total).toBeGreaterThan(100);
    expect(bodies(world).count).toBe(count - mergers(world).total);
    expect(totalMass(world)).toBeCloseTo(before.mass, 9);
    const { x: px, y: py, z: pz } = momentum(world);
    expect(Math.hypot(px, py, pz)).toBeLessThan(1e-9);
    const centre = centreOfMass(world);
    for (const axis of ['x', 'y', 'z'] as const) expect(centre[axis]).toBeCloseTo(before.centre[axis], 9);
    expect(world.faults.faults).toEqual([]);
  });

  test('in a world of rigid bodies discs merge, and neither boxes, sensors nor kinematic bodies', () => {
    const warnings: string[] = [];
    const onWarning = ({ message }: { readonly message: string }) => warnings.push(message);
    const world = mergingWorld({ preset: rigidBodies, onWarning });
    const pair = (y: number, a: Partial<BodyInput>, b: Partial<BodyInput> = {}) =>
      [a, b].map((input, i) =>
        spawn(world, { position: { x: 0.5 * i, y }, velocity: {}, mass: 2 - i, collider: { radius: 0.3 }, ...input }),
      );
    const drops = pair(0, {});
    const others = [
      // Their circles overlap, and they do not.
      pair(5, { collider: { shape: box(0.4, 2) } }, { collider: { shape: box(0.4, 2) } }),
      pair(10, { collider: { shape: box(0.5, 0.5) } }),
      pair(15, { collider: { radius: 0.3, sensor: true } }),
      pair(20, { kinematic: {} }),
    ].flat();
    for (let i = 0; i < 3; i++) step(world, 1e-3);
    expect(mergers(world).total).toBe(1);
    expect(drops.map((id) => isBody(world, id))).toEqual([true, false]);
    for (const id of others) expect(isBody(world, id), `${id}`).toBe(true);
    expect(warnings.filter((message) => message.includes('mergeOnContact'))).toEqual([
      `body ${others[0]} never merges, because mergeOnContact merges discs only, and it has another shape.`,
    ]);
  });
});
