/** Shared by tests of the law language: crowds of bodies with gaps, and the force of a law. */
import {
  bodies,
  COMPONENTS,
  createPhysicsWorld,
  defineLaw,
  despawn,
  evaluateForces,
  type Force,
  type LawOptions,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  spawn,
} from '@principia/physics';
import { expect } from 'vitest';

/** Every kind of world: lanes of two doubles and of four floats, with and without z. */
export const WORLD_KINDS = [
  { dimensions: 2, precision: 'f64' },
  { dimensions: 2, precision: 'f32' },
  { dimensions: 3, precision: 'f64' },
  { dimensions: 3, precision: 'f32' },
] as const;

export type WorldKind = (typeof WORLD_KINDS)[number];
export type Axis = 'x' | 'y' | 'z';

/** Returns the law as a force. */
export function lawOf(options: LawOptions<never, never> | object, parameters: object = {}): Force {
  const make = defineLaw({ name: 'law of a test', ...options } as never) as unknown as (given: object) => Force;
  return make(parameters);
}

/** Three components with one column of reals each, which nothing else in these worlds reads. */
export const THREE_READS = {
  a: COMPONENTS.Charge,
  b: COMPONENTS.LinearDrag,
  c: COMPONENTS.QuadraticDrag,
};

/** Those columns of a world, to be written as the test likes: a law must do with whatever bits there are. */
export function columnsOfThree({ components }: PhysicsWorld) {
  return {
    a: components.Charge.value,
    b: components.LinearDrag.coefficient,
    c: components.QuadraticDrag.coefficient,
  };
}

/** A world with bodies in rows that do not follow each other, so that lanes are partly empty. */
export function crowd(forces: readonly Force[], options: PhysicsWorldOptions = {}, count = 21) {
  const world = createPhysicsWorld({ capacity: 100, forces, ...options });
  const spawned = Array.from({ length: count }, () =>
    spawn(world, { position: {}, velocity: {}, mass: 1, charge: 0, linearDrag: 0, quadraticDrag: 0 }),
  );
  const left = spawned.filter((eid) => ![2, 7, 8, 12].includes(eid));
  for (const eid of spawned) if (!left.includes(eid)) despawn(world, eid);
  bodies(world);
  return { world, eids: left };
}

/** Evaluates the world's forces and returns their columns. */
export function forcesNow(world: PhysicsWorld, time = world.time) {
  bodies(world);
  const { scratch, kernels, addresses, ranges, rows } = world;
  for (const axis of ['x', 'y', 'z'] as const) {
    kernels.copyColumn(scratch.at.startVelocity[axis], addresses.Velocity[axis], 0, rows);
  }
  evaluateForces(world, ranges, time);
  return scratch.force;
}

/** Returns a number rounded to the world's precision. */
export function rounderOf(precision: 'f32' | 'f64'): (value: number) => number {
  return precision === 'f32' ? Math.fround : (value) => value;
}

/** The same number with the same sign of zero. A NaN is a NaN: which one is left to the machine. */
export function expectSameBits(got: number, wanted: number, what: string): void {
  if (Object.is(got, wanted)) return;
  expect(`${what}: ${Object.is(got, -0) ? '-0' : got}`).toBe(`${what}: ${Object.is(wanted, -0) ? '-0' : wanted}`);
}
