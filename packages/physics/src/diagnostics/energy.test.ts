import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { attractors } from '../forces/attractors.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { createRandom } from '../math/random.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { angularMomentum, centreOfMass, energy, momentum, totalMass } from './energy.ts';

describe('energy', () => {
  test('kinetic of translation and rotation; potential of each law', () => {
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 10,
      forces: [uniformGravity({ z: -10 }), springs(), attractors()],
    });
    const a = spawn(world, {
      position: { z: 3 },
      velocity: { x: 1, y: 2, z: 2 },
      mass: 2,
      inertia: 4,
      angularVelocity: { x: 1, z: 2 },
    });
    const b = spawn(world, { position: { x: 4, z: 3 } });
    spawn(world, { spring: { a, b, stiffness: 6, length: 1 } });
    spawn(world, { position: { y: 4 }, attractor: { mu: 10, softening: 12 } });
    const { kinetic, potential, total } = energy(world);
    expect(kinetic).toBe(9 + 10);
    expect(potential).toBeCloseTo(2 * 10 * 3 + 27 - (2 * 10) / 13, 12);
    expect(total).toBe(kinetic + potential);
  });

  test('work done is the change of kinetic energy (ch04-work-energy-power)', () => {
    const world = createPhysicsWorld({ capacity: 10, forces: [uniformGravity({ y: -10 })] });
    spawn(world, { position: {}, velocity: { x: 3 }, mass: 2 });
    const before = energy(world);
    for (let i = 0; i < 100; i++) step(world, 0.01);
    const after = energy(world);
    expect(after.kinetic - before.kinetic).toBeCloseTo(before.potential - after.potential, 9);
    expect(after.kinetic - before.kinetic).toBeCloseTo((2 * 10 * 10) / 2, 9);
  });
});

describe('momentum and angular momentum', () => {
  test('a net of springs in space conserves both', () => {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 100, forces: [springs()] });
    const random = createRandom(3);
    const anywhere = () => ({ x: random.gaussian(), y: random.gaussian(), z: random.gaussian() });
    const ids = Array.from({ length: 12 }, () =>
      spawn(world, { position: anywhere(), velocity: anywhere(), mass: random.uniform(1, 3) }),
    );
    for (let i = 0; i < ids.length; i++) {
      const ends = { a: ids[i], b: ids[(i + 5) % ids.length] };
      spawn(world, { spring: { ...ends, stiffness: 30, length: 1, damping: 0.3 } });
    }
    const [p, l, centre] = [momentum(world), angularMomentum(world), centreOfMass(world)];
    const start = energy(world).total;
    for (let i = 0; i < 1000; i++) step(world, 0.005);
    for (const axis of ['x', 'y', 'z'] as const) {
      expect(momentum(world)[axis]).toBeCloseTo(p[axis], 11);
      // Damping also acts along the line, so only the integrator's predictor for it violates the torque balance.
      expect(Math.abs(angularMomentum(world)[axis] - l[axis])).toBeLessThan(1e-3);
      expect(centreOfMass(world)[axis]).toBeCloseTo(centre[axis] + (p[axis] / totalMass(world)) * 5, 10);
    }
    expect(energy(world).total).toBeLessThan(start);
  });

  test('about another point it differs by r × p', () => {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 10 });
    spawn(world, { position: { x: 1, y: 2, z: 3 }, velocity: { x: -1, y: 0.5, z: 2 }, mass: 2 });
    spawn(world, { position: { x: -3 }, velocity: { z: 1 }, mass: 1, inertia: 5, angularVelocity: { y: 2 } });
    const p = momentum(world);
    const [here, there] = [angularMomentum(world), angularMomentum(world, { x: 1, y: -2, z: 0.5 })];
    expect(here.x - there.x).toBeCloseTo(-2 * p.z - 0.5 * p.y, 13);
    expect(here.y - there.y).toBeCloseTo(0.5 * p.x - 1 * p.z, 13);
    expect(here.z - there.z).toBeCloseTo(1 * p.y + 2 * p.x, 13);
    expect(here.y).toBe(2 * (3 * -1 - 1 * 2) + 3 + 10);
  });

  test('in the plane only z turns', () => {
    const world = createPhysicsWorld({ capacity: 10 });
    spawn(world, { position: { x: 2 }, velocity: { y: 3 }, mass: 4, inertia: 2, angularVelocity: 5 });
    expect(angularMomentum(world)).toEqual({ x: 0, y: 0, z: 34 });
  });
});
