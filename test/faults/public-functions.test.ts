/** Every public function against a destroyed world, against what is no world, and against unknown keys. */
import * as physics from '@principia/physics';
import {
  clearFaults,
  createPhysicsWorld,
  createRunner,
  destroyWorld,
  type EntityRef,
  localSystem,
  on,
  type PhysicsWorld,
  resetProfile,
  resource,
  rgba,
  spawn,
  startProfile,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { assertRefused, assertWorldAlive, ball, groundWorld, refusal } from '../support/worlds.ts';

const counter = resource(() => ({ count: 0 }));

/** One valid call of every function that takes a world. */
const ON_A_WORLD: Record<string, (world: PhysicsWorld) => unknown> = {
  angularMomentum: (world) => physics.angularMomentum(world),
  bodies: (world) => physics.bodies(world),
  centreOfMass: (world) => physics.centreOfMass(world),
  createRunner: (world) => physics.createRunner(world),
  despawn: (world) => physics.despawn(world, 1),
  energy: (world) => physics.energy(world),
  entityRef: (world) => physics.entityRef(world, 1),
  isAlive: (world) => physics.isAlive(world, 1 as EntityRef),
  isBody: (world) => physics.isBody(world, 1),
  momentum: (world) => physics.momentum(world),
  on: (world) => physics.on(world, 'fault', () => {}),
  removedSprings: (world) => physics.removedSprings(world),
  replaceForce: (world) => physics.replaceForce(world, physics.uniformGravity()),
  resolve: (world) => physics.resolve(world, 1 as EntityRef),
  'resource(…)': (world) => counter(world),
  spawn: (world) => physics.spawn(world, { position: {} }),
  spawnMany: (world) => physics.spawnMany(world, 2, { position: {} }),
  startProfile: (world) => physics.startProfile(world, () => 0),
  stateHash: (world) => physics.stateHash(world),
  step: (world) => physics.step(world, 0.1),
  stopProfile: (world) => physics.stopProfile(world),
  totalMass: (world) => physics.totalMass(world),
};

/** Functions that take no world, or that only the step calls, and `destroyWorld`, which may come twice. */
const OTHERS = [
  ...['PhysicsError', 'boxWalls', 'clearFaults', 'createPhysicsWorld', 'defineForce', 'destroyWorld'],
  ...['evaluateForces', 'linearDrag', 'localSystem', 'quadraticDrag', 'resetProfile', 'resource', 'rgba', 'standard'],
  ...['uniformGravity', 'atan2', 'cos', 'createRandom', 'exp', 'log', 'pow', 'sin', 'attractors', 'springs', 'gusts'],
];

describe('61 use after destroy', () => {
  it.each(Object.keys(ON_A_WORLD))('61 %s gives E_DESTROYED', (name) => {
    const world = groundWorld();
    ball(world, 0, 1);
    destroyWorld(world);
    expect(refusal(() => ON_A_WORLD[name](world)).code).toBe('E_DESTROYED');
  });

  it.each(Object.keys(ON_A_WORLD))('%s refuses what is no world with E_TYPE', (name) => {
    for (const bad of [undefined, null, {}, 5]) {
      expect(refusal(() => ON_A_WORLD[name](bad as never)).code).toBe('E_TYPE');
    }
  });

  it('61 no public function is forgotten here', () => {
    const functions = Object.entries(physics).flatMap(([name, value]) => (typeof value === 'function' ? [name] : []));
    const covered = new Set([...Object.keys(ON_A_WORLD), ...OTHERS]);
    expect(functions.filter((name) => !covered.has(name))).toEqual([]);
  });
});

describe('arguments', () => {
  it('spawn refuses what is no description of a body, and lists the valid keys', () => {
    const world = groundWorld();
    ball(world, 0, 1);
    for (const bad of [null, undefined, 5, 'ball', [], () => 0]) {
      assertRefused(world, () => spawn(world, bad as never), { code: 'E_TYPE' });
    }
    assertRefused(world, () => spawn(world, { radius: 1 } as never), {
      code: 'E_UNKNOWN',
      field: 'radius',
      hint: /position, velocity, mass/,
    });
    assertRefused(world, () => spawn(world, { position: { X: 1 } } as never), {
      code: 'E_UNKNOWN',
      field: 'X',
      hint: /x, y, z/,
    });
    assertRefused(world, () => spawn(world, { position: 5 } as never), { code: 'E_TYPE', field: 'position' });
    assertRefused(world, () => spawn(world, { mass: 'heavy' } as never), { code: 'E_TYPE', field: 'mass' });
    assertWorldAlive(world);
  });

  it.each([
    [{ capacity: 0 }, 'E_RANGE', 'capacity'],
    [{ capacity: 1.5 }, 'E_RANGE', 'capacity'],
    [{ capacity: '5' }, 'E_TYPE', 'capacity'],
    [{ capacity: NaN }, 'E_NONFINITE', 'capacity'],
    [{ seed: -1 }, 'E_RANGE', 'seed'],
    [{ dimensions: 4 }, 'E_RANGE', 'dimensions'],
    [{ precision: 'f16' }, 'E_RANGE', 'precision'],
    [{ onFault: 'ignore' }, 'E_RANGE', 'onFault'],
    [{ arenaBytes: -1 }, 'E_RANGE', 'arenaBytes'],
    [{ memoryFactory: 5 }, 'E_TYPE', 'memoryFactory'],
    [{ gravity: 5 }, 'E_UNKNOWN', 'gravity'],
    [null, 'E_TYPE', 'createPhysicsWorld'],
    [5, 'E_TYPE', 'createPhysicsWorld'],
  ])('a world with options %o is refused with %s', (options, code, field) => {
    expect(refusal(() => createPhysicsWorld(options as never))).toMatchObject({ code, field });
  });

  it('on refuses an event there is not and a handler that is none', () => {
    const world = groundWorld();
    expect(refusal(() => on(world, 'colision' as never, () => {}))).toMatchObject({
      code: 'E_UNKNOWN',
      hint: expect.stringMatching(/contact, fault/),
    });
    expect(refusal(() => on(world, '__proto__' as never, () => {})).code).toBe('E_UNKNOWN');
    expect(refusal(() => on(world, 'fault', undefined as never)).code).toBe('E_TYPE');
  });

  it('the small ones refuse what they cannot use', () => {
    const world = groundWorld();
    expect(refusal(() => startProfile(world, performance as never)).code).toBe('E_TYPE');
    expect(refusal(() => localSystem('mine', undefined as never)).code).toBe('E_TYPE');
    expect(refusal(() => clearFaults(undefined as never)).code).toBe('E_TYPE');
    expect(refusal(() => resetProfile(undefined as never)).code).toBe('E_TYPE');
    expect(refusal(() => resource(5 as never)).code).toBe('E_TYPE');
    expect(refusal(() => rgba(NaN, 0, 0)).code).toBe('E_NONFINITE');
    expect(refusal(() => createRunner(world, 5 as never)).code).toBe('E_TYPE');
    expect(refusal(() => physics.angularMomentum(world, { x: NaN })).code).toBe('E_NONFINITE');
  });

  it('an error says what, where, which value, and what to do', () => {
    const error = refusal(() => spawn(groundWorld(), { mass: 0 }));
    expect(error).toMatchObject({ name: 'PhysicsError', code: 'E_RANGE', field: 'mass', value: 0 });
    expect(error.message).toBe(
      'E_RANGE: mass must be greater than 0, got 0. For a body that forces do not move, leave Mass out.',
    );
  });
});
