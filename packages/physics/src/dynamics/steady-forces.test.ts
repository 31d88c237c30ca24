// Tests which forces count as the same throughout a step, and that those which are not are evaluated in every sub-step.
import { expect, test } from 'vitest';
import {
  attractors,
  createPhysicsWorld,
  defineForce,
  defineLaw,
  electricField,
  type Force,
  linearDrag,
  restrictForce,
  rigidBodies,
  softStep,
  spawn,
  step,
  thrust,
  uniformGravity,
  vec3,
} from '../index.ts';
import { areForcesSteady } from './steady-forces.ts';

const never = defineForce({ name: 'none', equation: 'F = 0', reads: [], local: true, accumulate() {} });
const byClock = defineLaw({ name: 'by the clock', force: ({ time }) => vec3(time, 0, 0) });
const byOthers = defineLaw({ name: 'twice', force: ({ force }) => force });

test.each<[string, readonly Force[], boolean]>([
  ['no force', [], true],
  ['weight', [uniformGravity({ y: -10 })], true],
  ['charges in a field', [electricField({ x: 3 })], true],
  ['twice the weight', [uniformGravity({ y: -10 }), byOthers()], true],
  ['charges in a field that changes', [electricField((time) => ({ x: time }))], false],
  ['a law that reads the time', [byClock()], false],
  ['drag', [uniformGravity({ y: -10 }), linearDrag()], false],
  ['thrust', [thrust()], true],
  ['thrust that turns with the body', [thrust({ frame: 'body' })], false],
  [
    'weight in a region',
    [restrictForce(uniformGravity({ y: -10 }), { region: { min: { x: 0, y: 0 }, max: { x: 1, y: 1 } } })],
    false,
  ],
  ['attraction', [attractors()], false],
  ['a function', [never], false],
])('%s: %#', (_, forces, expected) => {
  expect(areForcesSteady(createPhysicsWorld({ dimensions: 2, forces }))).toBe(expected);
});

test.each([1, 4, 9])('a force that grows with time is summed over %i sub-steps', (substeps) => {
  const world = createPhysicsWorld({
    dimensions: 2,
    precision: 'f64',
    preset: rigidBodies,
    integrator: softStep({ substeps }),
    forces: [byClock()],
  });
  const eid = spawn(world, { position: { x: 0, y: 0 }, velocity: { x: 0, y: 0 }, mass: 1 });
  const dt = 0.125;
  for (let i = 0; i < 4; i++) step(world, dt);
  // The sum of h t over all sub-steps, h (n - 1) n h/2.
  const [n, h] = [4 * substeps, dt / substeps];
  expect(world.components.Velocity.x[eid]).toBeCloseTo((h * h * n * (n - 1)) / 2, 12);
});
