import { expect, test } from 'vitest';
import { codeOf, emitting, living } from '../../../../test/support/emitting.ts';
import { momentum } from '../diagnostics/energy.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { burst } from './emitter.ts';
import { createPattern } from './pattern.ts';

// Opposite pairs of exact binary fractions, whose sum is exactly zero.
const PAIRS = [
  { x: 3, y: 0.5 },
  { x: -3, y: -0.5 },
  { x: -1, y: 2 },
  { x: 1, y: -2 },
];

test('a burst uses the scaled velocities of its pattern in turn and adds its own velocity', () => {
  const { world, emitter } = emitting({ lifetime: 5, mass: 2, speed: 100, velocitySpread: { x: 0 } });
  burst(emitter, 8, { pattern: createPattern(world, PAIRS), scale: 2, velocity: { y: 4 }, position: { x: 10 } });
  step(world, 1 / 64);
  const { Position, Velocity } = world.components;
  const ids = living(emitter);
  expect(ids.map((eid) => [Velocity.x[eid], Velocity.y[eid]])).toEqual(
    [...PAIRS, ...PAIRS].map(({ x, y }) => [2 * x, 2 * y + 4]),
  );
  expect(Position.x[ids[0]]).toBe(10 + 6 / 64);
  // Eight particles of 2 kg: only the burst's velocity of 4 m/s contributes to the sum.
  expect(momentum(world)).toEqual({ x: 0, y: 64, z: 0 });
});

test('a pattern draws as many random numbers as a drawn direction, so the next particle is the same', () => {
  const states = [true, false].map((hasPattern) => {
    const { world, emitter } = emitting({ lifetime: [1, 2], speed: [1, 2] });
    burst(emitter, 4, hasPattern ? { pattern: createPattern(world, PAIRS) } : {});
    step(world, 1 / 64);
    burst(emitter, 1);
    step(world, 1 / 64);
    return world.components.Velocity.x[living(emitter)[4]];
  });
  expect(states[0]).toBe(states[1]);
});

test('invalid patterns are refused', () => {
  const { world, emitter } = emitting();
  const other = createPhysicsWorld({ capacity: 10 });
  expect(codeOf(() => createPattern(world, []))).toBe('E_RANGE');
  expect(codeOf(() => createPattern(world, [{ x: Number.NaN }]))).toBe('E_NONFINITE');
  expect(codeOf(() => createPattern(world, [{ z: 1 }]))).toBe('E_RANGE');
  const foreign = createPattern(other, PAIRS);
  expect(codeOf(() => burst(emitter, 4, { pattern: foreign }))).toBe('E_RANGE');
  expect(codeOf(() => burst(emitter, 4, { scale: Number.POSITIVE_INFINITY }))).toBe('E_NONFINITE');
});
