// What is used twice: a parameter under two names or in two laws, and an expression of a torque.
import { expect, test } from 'vitest';
import { forcesNow } from '../../../../test/support/law-lab.ts';
import {
  createPhysicsWorld,
  defineLaw,
  type Force,
  lawFromPotential,
  scalar,
  spawn,
  step,
  type VectorSymbol,
  vec3,
  vector,
} from '../index.ts';

/** What forces exert on a body at x = 1, N. */
function exertedBy(...forces: readonly Force[]): [number, number] {
  const world = createPhysicsWorld({ capacity: 1, precision: 'f64', forces: [...forces] });
  const body = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
  const { x, y } = forcesNow(world);
  return [x[body], y[body]];
}

test('one parameter under two names has two values', () => {
  const metre = scalar('m', { min: 0 });
  const shell = defineLaw({
    name: 'shell',
    parameters: { inner: metre, outer: metre },
    force: (_body, { inner, outer }) => vec3(inner, outer),
  });
  expect(exertedBy(shell({ inner: 1, outer: 3 }))).toEqual([1, 3]);
  const push = vector('N');
  const both = defineLaw({ name: 'both', parameters: { a: push, b: push }, force: (_body, { a, b }) => a.add(b) });
  expect(exertedBy(both({ a: { x: 1 }, b: { x: 5, y: 2 } }))).toEqual([6, 2]);
  const stiffness = scalar('N/m');
  const spring = lawFromPotential({
    name: 'spring with a load',
    parameters: { k: stiffness, load: stiffness },
    potential: ({ position: { x } }, { k, load }) => x.mul(x).mul(k).mul(0.5).sub(x.mul(load)),
  });
  expect(exertedBy(spring({ k: 2, load: 7 }))).toEqual([5, 0]);
});

test('one parameter in two laws has two values', () => {
  const newton = scalar('N');
  const right = defineLaw({ name: 'right', parameters: { f: newton }, force: (_body, { f }) => vec3(f, 0) });
  const up = defineLaw({ name: 'up', parameters: { f: newton }, force: (_body, { f }) => vec3(0, f) });
  expect(exertedBy(right({ f: 2 }), up({ f: 3 }))).toEqual([2, 3]);
});

test('a torque of n expressions, each of which uses the one before twice, is recorded in a time like n', () => {
  const twist = defineLaw({
    name: 'twist',
    torque: ({ angularVelocity }) => {
      let sum: VectorSymbol = angularVelocity;
      for (let i = 0; i < 100; i++) sum = sum.add(sum).mul(0.5);
      return sum;
    },
  });
  // Written out these are 2¹⁰⁰ operations.
  const world = createPhysicsWorld({ capacity: 1, precision: 'f64', forces: [twist()] });
  const body = spawn(world, { position: {}, rotation: 0, angularVelocity: 3, inertia: 1, mass: 1 });
  step(world, 1 / 8);
  expect(world.components.AngularVelocity.z[body]).toBe(3 + 3 / 8);
});
