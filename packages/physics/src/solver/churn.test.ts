// Bodies and joints that come and go at random leave no contact, box or joint behind, and the result is the same twice.
import {
  box,
  capsule,
  createJoint,
  createPhysicsWorld,
  createRandom,
  despawn,
  distance,
  isBody,
  type PhysicsWorld,
  polygon,
  revolute,
  rigidBodies,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { expect, test } from 'vitest';
import { RigidTableWord as Word } from '../memory/layouts.gen.ts';
import { rigidTable } from './rigid-table.ts';

const SHAPES = [box(0.6, 0.4), capsule(0.5, 0.15), polygon([{}, { x: 0.6 }, { x: 0.3, y: 0.5 }]), undefined];

/** The contacts of the solver are sorted pairs of bodies that are there, and no record is lost. */
function checkContacts(world: PhysicsWorld): void {
  const { words } = rigidTable(world);
  expect(words[Word.contactCount] + words[Word.freeCount]).toBe(words[Word.contactCapacity]);
  const order = new Uint32Array(world.memory.buffer, words[Word.order], words[Word.contactCount]);
  // The highest bit tells of contacts that are settled.
  expect(new Set(order.map((entry) => entry & 0x7fffffff)).size).toBe(order.length);
}

function churn(precision: 'f32' | 'f64', seed: number): string {
  const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 300, forces: [uniformGravity()] });
  const random = createRandom(seed);
  for (const [x, y, w, h] of [
    [0, -0.5, 12, 1],
    [-6, 3, 1, 8],
    [6, 3, 1, 8],
  ]) {
    spawn(world, { position: { x, y }, collider: { shape: box(w, h), friction: 0.5 } });
  }
  const ids: number[] = [];
  for (let i = 0; i < 400; i++) {
    if (ids.length < 120 && random.uniform(0, 1) < 0.6) {
      const shape = SHAPES[Math.floor(random.uniform(0, SHAPES.length))];
      const collider = {
        ...(shape === undefined ? { radius: 0.25 } : { shape }),
        density: random.uniform(0.5, 50),
        friction: 0.5,
      };
      ids.push(spawn(world, { position: { x: random.uniform(-4, 4), y: random.uniform(4, 6) }, collider }));
    }
    if (ids.length > 2 && random.uniform(0, 1) < 0.2) {
      const [a, b] = [0, 1].map(() => ids[Math.floor(random.uniform(0, ids.length))]);
      const anchor = { x: world.components.Position.x[a], y: world.components.Position.y[a] };
      if (a !== b) createJoint(world, random.uniform(0, 1) < 0.5 ? revolute({ a, b, anchor }) : distance({ a, b }));
    }
    if (ids.length > 0 && random.uniform(0, 1) < 0.3) {
      const [gone] = ids.splice(Math.floor(random.uniform(0, ids.length)), 1);
      despawn(world, gone);
    }
    step(world, 1 / 60);
    checkContacts(world);
  }
  for (const id of ids) {
    expect(isBody(world, id)).toBe(true);
    expect(Math.abs(world.components.Position.x[id])).toBeLessThan(100);
  }
  expect(world.faults.faults).toEqual([]);
  const hash = stateHash(world);
  for (const id of ids) despawn(world, id);
  step(world, 1 / 60);
  expect([rigidTable(world).words[Word.contactCount], world.internal.counts.Joint]).toEqual([0, 0]);
  return hash;
}

test.each(['f32', 'f64'] as const)('bodies and joints come and go in %s', (precision) => {
  expect(churn(precision, 1)).toBe(churn(precision, 1));
  for (const seed of [2, 3, 4]) churn(precision, seed);
});

test('a plank carries more boxes than there are colors', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 200, forces: [uniformGravity()] });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(200, 1), friction: 0.6 } });
  const plank = spawn(world, { position: { y: 0.25 }, collider: { shape: box(60, 0.5), density: 1, friction: 0.6 } });
  const boxes = Array.from({ length: 50 }, (_, i) =>
    spawn(world, {
      position: { x: 1.1 * (i - 24.5), y: 1 },
      collider: { shape: box(1, 1), density: 1, friction: 0.6 },
    }),
  );
  for (let i = 0; i < 300; i++) step(world, 1 / 60);
  const { y } = world.components.Position;
  expect(y[plank]).toBeCloseTo(0.25, 2);
  for (const id of boxes) expect(y[id]).toBeCloseTo(1, 2);
});

test('the last entity leaves nothing behind: neither a body nor what slept on it', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 20, forces: [uniformGravity()] });
  const crate = () => spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
  const sleeper = crate();
  const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
  for (let i = 0; i < 120; i++) step(world, 1 / 60);
  despawn(world, ground);
  for (let i = 0; i < 60; i++) step(world, 1 / 60);
  const { y } = world.components.Position;
  expect(y[sleeper]).toBeLessThan(-2);
  despawn(world, sleeper);
  const next = crate();
  for (let i = 0; i < 60; i++) step(world, 1 / 60);
  expect(y[next]).toBeLessThan(-2);
});
