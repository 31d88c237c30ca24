// Properties of all collisions, tested on random scenes.
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  ballInertia,
  boxWalls,
  createPhysicsWorld,
  discInertia,
  energy,
  momentum,
  type PhysicsWorld,
  particleContacts,
  spawn,
  step,
} from '../index.ts';

const DT = 1 / 60;
const STEPS = 60;

const between = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const place = fc.record({ x: between(-2, 2), y: between(-2, 2), z: between(-2, 2) });
const push = fc.record({ x: between(-20, 20), y: between(-20, 20), z: between(-20, 20) });
const oneBody = fc.record({
  position: place,
  velocity: push,
  mass: between(0.1, 10),
  radius: between(0.1, 0.6),
  restitution: between(0, 1),
  friction: fc.constantFrom(0, 0.5),
  spin: between(-10, 10),
});
type Body = typeof oneBody extends fc.Arbitrary<infer T> ? T : never;
const crowd = fc.array(oneBody, { minLength: 2, maxLength: 12 });
/** Excludes coincident bodies, whose separation direction depends on their ids. */
const apart = fc.uniqueArray(oneBody, {
  minLength: 2,
  maxLength: 12,
  comparator: ({ position: a }, { position: b }) => Math.abs(a.x - b.x) + Math.abs(a.y - b.y) < 1e-3,
});

/**
 * Creates the bodies in free space, or for `side` -1 their mirror image in the plane x = 0, which reverses spins about
 * y and z.
 */
function worldOf(bodies: readonly Body[], dimensions: 2 | 3, side: 1 | -1 = 1): PhysicsWorld {
  const world = createPhysicsWorld({ preset: particleContacts, dimensions, precision: 'f64', capacity: 100 });
  const inertia = dimensions === 2 ? discInertia : ballInertia;
  const flat = ({ x, y, z }: Body['position']) => ({ x: side * x, y, ...(dimensions === 3 ? { z } : {}) });
  for (const { position, velocity, mass, radius, restitution, friction, spin } of bodies) {
    spawn(world, {
      position: flat(position),
      velocity: flat(velocity),
      mass,
      inertia: inertia(mass, radius),
      angularVelocity: { z: side * spin },
      collider: { radius, restitution, friction },
    });
  }
  return world;
}

describe.each([2, 3] as const)('many bodies in %d D', (dimensions) => {
  test('conserve momentum to rounding', () => {
    fc.assert(
      fc.property(crowd, (bodies) => {
        const world = worldOf(bodies, dimensions);
        const before = momentum(world);
        const { Mass, Velocity } = world.components;
        let scale = 0;
        for (let i = 1; i <= bodies.length; i++) {
          scale += Mass.value[i] * (Math.abs(Velocity.x[i]) + Math.abs(Velocity.y[i]) + Math.abs(Velocity.z[i]));
        }
        for (let s = 0; s < STEPS; s++) step(world, DT);
        const after = momentum(world);
        // Each impulse rounds two velocities. There are at most about 66 pairs, each solved up to 30 times per step.
        const bound = STEPS * 66 * 30 * 2 * Number.EPSILON * (scale + 1);
        for (const axis of ['x', 'y', 'z'] as const) expect(Math.abs(after[axis] - before[axis])).toBeLessThan(bound);
      }),
      { seed: 1, numRuns: 100 },
    );
  });

  test('gain no energy if no restitution exceeds one', () => {
    fc.assert(
      fc.property(crowd, (bodies) => {
        const world = worldOf(bodies, dimensions);
        let last = energy(world).kinetic;
        for (let s = 0; s < STEPS; s++) {
          step(world, DT);
          const now = energy(world).kinetic;
          expect(now).toBeLessThanOrEqual(last * (1 + 1e-12));
          last = now;
        }
      }),
      { seed: 2, numRuns: 100 },
    );
  });

  test('have bitwise mirrored trajectories in a mirrored scene', () => {
    fc.assert(
      fc.property(apart, (bodies) => {
        const [plain, mirrored] = [worldOf(bodies, dimensions), worldOf(bodies, dimensions, -1)];
        for (let s = 0; s < STEPS; s++) {
          step(plain, DT);
          step(mirrored, DT);
        }
        for (let i = 1; i <= bodies.length; i++) {
          for (const name of ['Position', 'Velocity'] as const) {
            const [a, b] = [plain.components[name], mirrored.components[name]];
            expect([a.x[i] + 0, a.y[i], a.z[i]]).toEqual([-b.x[i] + 0, b.y[i], b.z[i]]);
          }
        }
      }),
      { seed: 3, numRuns: 50 },
    );
  });

  test('a body does not tunnel through the walls of a box at any speed', () => {
    const fast = fc.record({
      speed: fc.record({ x: between(-1e5, 1e5), y: between(-1e5, 1e5), z: between(-1e5, 1e5) }),
      body: oneBody,
    });
    fc.assert(
      fc.property(fast, ({ speed, body }) => {
        const world = createPhysicsWorld({
          preset: particleContacts,
          dimensions,
          precision: 'f64',
          walls: [boxWalls({ min: { x: -3, y: -3, z: -3 }, max: { x: 3, y: 3, z: 3 } })],
        });
        const { x, y, z } = body.position;
        const collider = { radius: body.radius, restitution: body.restitution };
        const third = dimensions === 3;
        const eid = spawn(world, {
          position: { x, y, ...(third ? { z } : {}) },
          velocity: { x: speed.x, y: speed.y, ...(third ? { z: speed.z } : {}) },
          mass: 1,
          collider,
        });
        const { Position } = world.components;
        for (let s = 0; s < 20; s++) {
          step(world, DT);
          for (const axis of ['x', 'y', 'z'] as const) {
            expect(Math.abs(Position[axis][eid])).toBeLessThanOrEqual(3 - body.radius + 4 * Number.EPSILON);
          }
        }
      }),
      { seed: 4, numRuns: 200 },
    );
  });
});

test('a disc does not tunnel through the segments of a closed room at any speed', () => {
  const shot = fc.record({
    position: place,
    speed: between(1, 1e4),
    turn: between(0, 6.28),
    radius: between(0.05, 0.5),
  });
  fc.assert(
    fc.property(shot, ({ position, speed, turn, radius }) => {
      const world = createPhysicsWorld({ preset: particleContacts, precision: 'f64' });
      const corners = [-3, -3, 3, -3, 3, 3, -3, 3, -3, -3];
      for (let i = 0; i < 8; i += 2) {
        const [ax, ay, bx, by] = corners.slice(i, i + 4);
        spawn(world, { segmentWall: { ax, ay, bx, by, restitution: 1 } });
      }
      const eid = spawn(world, {
        position: { x: position.x, y: position.y },
        velocity: { x: speed * Math.cos(turn), y: speed * Math.sin(turn) },
        mass: 1,
        collider: { radius },
      });
      const { x, y } = world.components.Position;
      for (let s = 0; s < 20; s++) {
        step(world, DT);
        // A path is some hundred metres long, so rounding displaces the disc by at most a millionth of its radius.
        expect(Math.max(Math.abs(x[eid]), Math.abs(y[eid]))).toBeLessThan(3 - radius + 1e-7);
      }
    }),
    { seed: 5, numRuns: 200 },
  );
});
