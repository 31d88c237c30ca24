// What moveCharacter refuses.
import { box, createPhysicsWorld, moveCharacter, rigidBodies, spawn, stateHash } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { BODY, capsuleOf } from '../../../../test/support/character-world.ts';
import { DT } from '../../../../test/support/rigid-world.ts';

describe('bad input', () => {
  const world = createPhysicsWorld({ preset: rigidBodies });
  const id = spawn(world, { ...BODY, position: {}, collider: { shape: capsuleOf() } });

  test.each([
    ['a velocity of NaN', 'E_NONFINITE', () => moveCharacter(world, id, { x: Number.NaN }, DT)],
    ['no velocity', 'E_TYPE', () => moveCharacter(world, id, undefined as never, DT)],
    ['a step of no length', 'E_RANGE', () => moveCharacter(world, id, {}, 0)],
    ['an unknown option', 'E_UNKNOWN', () => moveCharacter(world, id, {}, DT, { slope: 1 } as never)],
    ['an up of zero', 'E_RANGE', () => moveCharacter(world, id, {}, DT, { up: {} })],
    ['a slope that overhangs', 'E_RANGE', () => moveCharacter(world, id, {}, DT, { maxSlope: 2 })],
    ['a margin that cannot be kept', 'E_RANGE', () => moveCharacter(world, id, {}, DT, { margin: 1e-6 })],
    ['a body that is not there', 'E_STALE', () => moveCharacter(world, 99, {}, DT)],
  ])('%s is refused', (_, code, call) => {
    const before = stateHash(world);
    expect(call).toThrow(expect.objectContaining({ code }));
    expect(stateHash(world)).toBe(before);
  });

  test('a body that forces move, one that never moves, and one with sharp corners say what to do', () => {
    const dynamic = spawn(world, { position: { x: 9 }, collider: { shape: capsuleOf(), density: 1 }, velocity: {} });
    expect(() => moveCharacter(world, dynamic, {}, DT)).toThrow(/kinematic: \{\}/);
    const still = spawn(world, { position: { x: 12 }, collider: { radius: 1 } });
    expect(() => moveCharacter(world, still, {}, DT)).toThrow(/velocity: \{\}/);
    const sharp = spawn(world, { position: { x: 15 }, velocity: {}, kinematic: {}, collider: { shape: box(1, 1) } });
    expect(() => moveCharacter(world, sharp, {}, DT)).toThrow(/capsule/);
    const solid = createPhysicsWorld({ dimensions: 3 });
    const ball = spawn(solid, { velocity: {}, collider: 1 });
    expect(() => moveCharacter(solid, ball, {}, DT)).toThrow(/two dimensions/);
  });

  test('a step in milliseconds gets a warning, once', () => {
    const warnings: string[] = [];
    const other = createPhysicsWorld({ preset: rigidBodies, onWarning: ({ message }) => warnings.push(message) });
    const walker = spawn(other, { ...BODY, position: {}, collider: { shape: capsuleOf() } });
    for (let i = 0; i < 3; i++) moveCharacter(other, walker, {}, 16.7);
    expect(warnings).toEqual([expect.stringContaining('milliseconds')]);
  });
});
